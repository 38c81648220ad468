<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>0: one degree less than the flank</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>1 to 9, where the tip lies; 0: by kind and hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>1: equal depths; 2: equal areas of chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A TrueType or OpenType file, instead of the font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A factor of the font's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A font of the system, or a single-line font for engraving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A laser's S word for marks; 0: a twentieth of its power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A laser's power that rises behind the pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A lower feed at corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A lower feed on arcs of a small radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A share of the machine's greatest power; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one circle; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one rectangle; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch, wires or faces: closed lines, those inside are islands</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>About the first corner, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Added between letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Align</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All, the outline, or the holes in it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All, the outlines of letters, or the holes in them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along Z, along X or along the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along a line or arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along which the sheets are stacked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Amperes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Approach</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc Centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc Start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc Sweep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc Tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs Feed Share</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs and lines this close to the drawn points, instead of the tolerance; 0: straight lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs of a smaller radius are cut slowly; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Around the jaws; 0: no jaws stand out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>As a multiple of the thickness; 0: none by thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>At smaller corners the wire neither pauses nor slows down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>At the full depth, besides the last one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Before zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Below thickness times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Below this grey, 1 to 255, it is dark; 0: found from the picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between neighbouring helices at most; 0: 0.4 of the tool's diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the cuts of two copies</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the flanks of a threading tool; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the front edge and the feed, given by the holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between two pieces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Beyond</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Blade Offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Blade offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Blur</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bridges that hold the part until it is broken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By Colour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By colour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By half of it all cuts are wider than their paths</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By which the radius grows towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Canned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Canned cycles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre Hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chains</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Changes of the job's own program since then</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chip Load Max</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chip Load Min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chuck Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clamp Containers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clamp Outlines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close gaps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Closed lines around the area to face; without them the whole stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Columns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Consumable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Containers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Containers of the clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copies on the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copies that are placed by the search may be turned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Core Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner A</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner B</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner Distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner Dwell</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner Feed Share</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner dwell</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners Distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners Feed Share</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners that turn by more are cut slowly; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Counts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Crest diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Current</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Curve Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut Height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Degression</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Deleted Drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth Of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth of cut ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dimensions</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance Mode</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distances</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dog-bones</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dogbones</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Double</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Doubles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawing, solid or picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings of rests of sheets, which are used first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings, sketches, shapes and operations whose outlines are nested</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dwell</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dynamic Power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dynamic power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge Margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>End angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ends that are nearer than this are moved together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engagement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engagement Max</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Enter From</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Enter from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entering angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry Slit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry slit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Exit of the wire: back along its entry, or the shortest way to an edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Extra depth, so that the tool comes out below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Face Stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fastest spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Faults</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed Per Turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed and speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed at corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed of arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed of holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed per turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Figures</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>File</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>File State</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finish</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finish Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finish Stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finish Stepover</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First Depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Floor diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flute Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Folder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Font file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For a mill that does not cut over its centre; 0: 10°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For the forces; empty: they are not figured</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Form</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Free length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From Chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the first hole, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the last hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the lines of the pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a cut to the edge of the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a piece to the edge of the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From hole to hole along X and along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From one turn of the thread to the next</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From that wall towards the end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the chuck's face to the finished end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the middle of the circle to the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the work zero (G90), or from the point before (G91)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From there towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Front Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Front edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G-code files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gaps up to this are closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Good Side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Good side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Grain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest Depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest depth of cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest engagement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width of the pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Heights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holder Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holder diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes of a smaller diameter are cut slowly; 0: none by diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes of a smaller diameter get a spot at their centre, no cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes with a shorter outline are cut slowly; 0: none by length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep a knife or point goes; 0: through the sheet, a point 0.2 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep one peck goes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep one peck goes; 0: in one go</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a bar or drill gets along Z, a blade along X; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a closed cut is followed with power beyond its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a closed line is followed beyond its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a drag knife's edge trails behind its axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a pierce stays from parts and cut edges; 0: that of the cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far above it the letters stand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far an arc turns, or how far a line leans away from the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far apart joints are at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far apart tabs are at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before and behind a corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before and behind a corner the feed is lower; 0: it is not</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before its end the cut runs on without power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before the material a rapid ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far behind the pierce the power is full</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far chords may leave an arc, where the controller has no arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far letters lean to the right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave other curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the pixels; 0: half a pixel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far one turn of the helix falls</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the arc goes; below 0 clockwise, with the letters outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the cut may be off the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the jaws stand out of the chuck's face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the kerf of a way through the scrap stays from every part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the raw end lies before the finished end face, where Z is 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the tool's rim runs over the edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the torch runs on over the begin of the cut without power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the wall may be off the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How high a tab is above the bottom of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How it is cut; the machine must be able to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How it was read last</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How long a spot has power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How long the flame heats before the pierce; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many corners and narrow places the tool does not reach into</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many gaps, doubles, crossings and other faults were found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes along X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes are made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many joints on each outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many of each are wanted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many parts are cut free</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many seconds a denser nest is looked for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many tabs hold the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many tabs on each line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many teeth; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many there are</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many there are: one, or one a tool in turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many turns the thread has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many; 0: those of the designation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the rim may be in the material at most, as an angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How often each line is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How often the tool pierces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply the tool goes down along the line; 0: straight down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the area is cleared</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the drill goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the thread winds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool comes to the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool is fed in from pass to pass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool leaves the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How wide a tab is at its top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How wide the material is that stays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Identity</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In front of the thread, where the tool catches up with the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In holes, or round bosses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In how many steps outwards</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Infeed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Infeed Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Infeed angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Into which a boring bar fits; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Invert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its code of ISO 1832, such as CNMG 120408; empty: by its angles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its designation: M20x2.5, 1/2-13 UNC, G1/2, Tr20x4</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its machine runs and checks the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its name in job files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jaw Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jaw diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jaws</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jobs and programs of the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Join</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Join ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Join only lines of one colour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Joints that hold the part until it is broken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kept</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerf Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerning</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kind</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead In Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead In By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead In Kind</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead In Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead In Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead Out Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead Out Kind</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead Out Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead Out Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead-in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead-out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leads</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leads as usual for the process, or with values of your own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Left on the face for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Left on the profile, normal to it, for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length Offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length that the controller adds to Z, if the machine uses a table of lengths; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length, width and height; for an upright cylinder the length is its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Levels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Light areas</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line Begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line End</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line Spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines nearer than this to another one are drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines of many points become fewer lines and arcs within this; 0: they stay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines that are marked with low power or lightly scribed before anything is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines up to this long are left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loop radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops in the scrap, which make outside corners sharp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made From</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made Of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Major</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Major Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mark Drawings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mark Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mark Power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marking feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marking power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material that a round tool leaves at the ends of the long axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material that stays between two cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mend</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Message</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Method</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Metres a minute at the bar's diameter; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn of the spindle, where the operation says nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn of the spindle; 0: the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn that the insert needs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn that the insert takes; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Minor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Minor Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Minor Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Most Turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Narrow arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nose Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nose radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Note</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nozzle, lens, wire or blade; empty: the first of the chart for this thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Objects</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a parting blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a sheet of material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of each part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of its curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of its tip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the bores; 0: that of each circle of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the capitals, or of the em</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the corners seen from above; 0: as round as the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the cutting edges; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the font, such as Bold; empty: the regular one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the grid about its first hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the tip below the finished end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the tip; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On which side of the cut the part lies, seen along it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On which side of the lines the tool runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One end of the diagonal, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One hole at each point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Orientation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Other corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Out of the hole for each peck, or to break the chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outlines of the clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outputs that are on while cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outside corners that turn by more get a loop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Over-burn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overcut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overhang</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pairs of letters stand as near as the font says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Part Values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts on all sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts without a place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Passes along</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pause of the wire where the path turns back; shorter at blunter corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Peck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce Delay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce Height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce delay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pixels an inch; 0: as the file says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Columns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place End</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place End Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Origin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Rows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place Start Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Placed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Placements</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plunge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plunge Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Point Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Point angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power Ramp Begin Share</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power Ramp By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power Ramp Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power on before the tool moves; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Preheat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Preview</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Problem</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program Part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program Parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Programs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pull Out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pull-out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Quarter turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radial Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius in pixels of a blur that takes out noise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius x</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp Max</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reach</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Region</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Registration Hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Registration holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remnants</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Repair</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as these values allow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Report</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest Corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest Corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Result</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract To</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Right hand cuts towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rules</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Search Time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Search time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Seconds at the bottom</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Section</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Setting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shank</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape Kind</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape of the raw material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet Grain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets There</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of material that the pieces take</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of the stack</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets that carry parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shorter than</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simplify</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slice Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slices</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Feed Share</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Over Run</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Thickness Ratio</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small Holes Torch Off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small holes at a feed of their own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smaller areas, in mm², are left out; 0: four pixels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smallest Bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smallest bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Speck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Specks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle Speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: by the surface speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: that of the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: those of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Split</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot Below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot holes below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spring Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spring passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Starts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>State</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Steepest ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepdown Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepover</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepover Used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock Form</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock Origin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock Size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock To Leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock to leave at the wall for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Style</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Surface Speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Surface speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs Height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs Made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs Spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs Width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tailstock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tailstock By</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Taper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The G-code file that it is, which has nothing to do with the operations of its job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The circles and points of sketches, or the circular edges of solids</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The clamps seen from above, at the height of their tops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The colour in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The corner where the grid begins, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The current set at the power source; 0: from the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The cut chart gives this value; change it in the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most, on the radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of the first pass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter at the other end of the flanks; 0: that of a metric thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter at which the cut ends; 0: over the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of a boring bar; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the centre hole; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the floor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the raw bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the surface into which it is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the tailstock's centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the tool holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the back edge away from the nose, from Z+ towards X+</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the front edge away from the nose, from Z+ towards X+</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the material's grain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The document and the name of the object itself; a copy still has those of its original</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing gives this value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing that the objects follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The edge of the sheet at which the wire enters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of marks; 0: that of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass; 0: the tool's own feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the program, in millimetres a turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The file of a cut chart of your own; empty: the chart that ships</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The fingerprint of the job's program from which this one was edited</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The flat at the tip of a V-bit or engraver; 0: it is pointed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The groups around it in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The half profile that it turns: a sketch, edges, a solid or points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The half profile whose diameter the thread has; without it the usual fit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The height of the rapids between holes: G98 or G99</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The inner diameter of a tube</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job with the machine, stock, tools and clamps for the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The layer in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of all cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the file's unit; 0: as the file says, or as its program usually means it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the lead's line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length over which the tool comes out at the end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length that the part keeps, below zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The limit of the surface speed; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The middle of the circle, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The minor diameter that is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The name in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The nominal diameter; 0: that of each circle of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The operations, in their order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The order in which the holes are made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The order in which the lines are cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The other end of the diagonal, before the rectangle is rotated</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The outline seen from above, or the faces or the section at a height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the drawings move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and the values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The place of the work zero in this document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The place of the work zero on the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The places of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The plunge feed of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program that is shown, checked and sent, if the machine needs one for each tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The programs and their places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The radius of loops at sharp outside corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The radius of the lead's arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed there; a slower wire melts a wider kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed with which they are cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the power at the pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wires or faces to cut: closed lines are parts and holes in turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wires or faces to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The solid and the values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of cutting moves; 0: that of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of the cut; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed straight down; 0: that of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The spindle's speed in the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest chip that a tooth bears; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest material left in inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest material left in them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool's X when the program begins, as radius or diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool's Z when the program begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The torch above the sheet while it cuts; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The torch above the sheet while it pierces; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The wall towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut where it is not the chart's; 0: the chart's, else the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut where it is not the tool's diameter; 0: the tool's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the cut chart or the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the picture; 0: as its resolution says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Their diameter; pins through them align the sheets; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Threshold</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Through</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Time of the tool at rest with power; 0: from the cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tiny</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip orientation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tolerance of the cut line, which reduces the number of moves; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool Shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools without feeds or speed use its table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Top Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Top diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Torch off before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Trace Tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Trace what is light instead of what is dark</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Units</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wall Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wall feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What becomes one object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is cut into sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is written; several lines are set below each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the X of a row is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the height is measured of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the insert takes, on the radius; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the letters stand on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the program's X is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the tool is for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was found in it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where it begins; 0: that of the profile or the usual fit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the arc begins; counter-clockwise from X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the copies lie</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the drawings are written; empty: beside the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the face lies when it is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the line begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the line ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the parts lie</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the program is written; empty: beside the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the row begins, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the row ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the text stands about its zero, or on its line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the thread begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the tool is when the program begins: clear of the raw end, or given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a centre holds the raw end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a laser's power follows its speed (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a slit through the part leads the wire into a closed hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether all of its chains are closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether form, kerf and feeds are those of the job's cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether inner corners are opened, so that a square corner fits in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether it works in a bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the depth is that of the point or of the full diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the file fills it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the file is as it was read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether their directions are those of insert and holder, or given by two angles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether threads are written as G76, where the controller has it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work Offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work Origin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X; Z of each point from the end face to the chuck; then chamfer, fillet, cw or ccw</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>XIs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the faces or of the section</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the wall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the whole stock</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper</name>
        <message>
            <source>'Install packages' asks first, and needs no administrator. You find it in the menu too.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'Install' fetches them from Python's package index and puts them into:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' has no meaning in a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' has several decimal separators; write 1234.5 or 1234,5</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no place; write X; Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no value in {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is not in the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0: one degree less than the flank</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0° to 270°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0°, 180°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>1 to 9, where the tip lies; 0: by kind and hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>1: equal depths; 2: equal areas of chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>45° blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>60° blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A TrueType or OpenType file, instead of the font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A bar above and a stem below, the zero in the middle of the bar's upper edge; three holes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A bore about the zero with a keyway above (DIN 6885: bore and key's depth over all).</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A chart's file…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A circle about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A controller is connected already.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A cross of two bars about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A deleted drawing is checked: uncheck it to go on without it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero less another one beside it, like a moon.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero with round notches in its rim and a bore.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero, cut off straight above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A drop: a disc about the zero and a point above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A factor of the font's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A file is checked with a job's machine, stock, tools and clamps; no operation is needed.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A flange of two bolts along X: a disc about the zero with an ear on each side.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A font of the system, or a single-line font for engraving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A heart of two half circles over a rounded tip, the zero in its notch.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A hole to hang a part on a screw: a circle about the zero for its head, a slot above for its shank.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A hook to hang things on: a plate with two holes above, the hook's round inside about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A job is being cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A job is being cut already: wait for its end, or stop it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A job is being cut: stop it first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A job is being cut: wait for its end, or stop it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A label about the zero: round corners, cut off on the left, with a hole for a string.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A laser's S word for marks; 0: a twentieth of its power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A laser's power that rises behind the pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A line for the controller, sent with Return. The arrow keys bring back the lines before.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A line of the program that was cut already.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A locked part stays where it is; press again to unlock it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A lower feed at corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A lower feed on arcs of a small radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A machine's profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A parallelogram, its left lower corner at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A piece of a ring about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate about the zero for a stepper motor of NEMA size 8, 11, 14, 17, 23 or 34.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate about the zero with an eye and a hole at each of three corners.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate to hang a load: a base below, an eye about the zero above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A polygon of equal sides about the zero, one side below; the size is across the flats.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A profile's file…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A program without F runs at {0} mm/min ({1}; kerf {2} mm).</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangle about the zero with its corners cut off at 45°.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangle about the zero, its corners sharp or round.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangular plate about the zero with a hole near each corner.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A right-angled stiffening plate, its right angle at the zero, cut off there to clear a weld.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A ring, or a washer, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round flange about the zero with a bore and a circle of bolt holes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round hole with flat sides above and below, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round hole with one flat side above, for shafts with a flat; about the circle's middle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A serial port, or an address as socket://192.168.0.7:23</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A share of the machine's greatest power; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A shield, the zero in the middle of its upper edge: straight sides, round below.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A short sound at an alarm, an end, a pause, and for a part beyond the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one circle; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one rectangle; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch, wires or faces: closed lines, those inside are islands</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slice of a disc about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slot in the edge of a plate for a bolt's head: open below, the zero at its mouth's middle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slot with round ends along an arc about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A square plate about the zero with a bore and a hole near each corner.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A star about the zero, one point above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A straight slot with round ends along X, about the zero; the length is over all.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A trapezoid, the zero in the middle of its base.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A triangle with two equal sides, the zero in the middle of its base.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A turn, as they are counted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A value is missing here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A wheel about the zero with saw teeth and a bore.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>About the first corner, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Acceleration</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Acceleration in steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Across the flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Across the flats</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add a G-code file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add a tool to this job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add drawings, sketches or operations of the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add jobs and programs of the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add selected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add selection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add the part in its present state to the document as a mesh</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add the tools of FreeCAD's library or of a tool table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Added between letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>After {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All = 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All files ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All lines are sent; the last moves are being cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All packages that CNCStepper works with are there.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All, the outline, or the holes in it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>All, the outlines of letters, or the holes in them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Allow jogging: spindle or beam off; Resume returns to the cut on a safe path.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along X, mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along Y, mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along Z, along X or along the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along Z, mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along a line or arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Along which the sheets are stacked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Also follow the selected lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>An angle of two legs, its outer corner at the zero, a hole near the end of each leg.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>An arrow along X, its tip at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>An expression gives this value; change it in the property editor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Angle out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Another machine?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Answer the question for the work zero with Start. On the virtual machine the path is free.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Apply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Approach</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs and lines this close to the drawn points, instead of the tolerance; 0: straight lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs of a smaller radius are cut slowly; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Around the jaws; 0: no jaws stand out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arrangement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arranging…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arrow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>As a multiple of the thickness; 0: none by thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>As many as can be made at most, in Hz</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>As people call the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>At smaller corners the wire neither pauses nor slows down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>At the end of {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>At the full depth, besides the last one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Attached again to the controller at {0}.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Axis arithmetic</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Axis whose sign changes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back along the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Back from here to the begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Backlash</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Backlash of the axis in the profile; the moves sent compensate it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Base</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Before zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Before {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Begin so much earlier on the same cut, so that no ridge stays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Begins at</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Being sent, {0} left</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Below thickness times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Below this grey, 1 to 255, it is dark; 0: found from the picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Belt's pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between neighbouring helices at most; 0: 0.4 of the tool's diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the cuts of two copies</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the flanks of a threading tool; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the front edge and the feed, given by the holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between two pieces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Beyond</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Blade offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Blur</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bore; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Boring</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Brackets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bridges that hold the part until it is broken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Busy</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By colour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By half of it all cuts are wider than their paths</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By which share the lathe may be slower than its published step times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>By which the radius grows towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bytes ahead at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper has a fault: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper works with these packages, which the Python {0} of this FreeCAD lacks:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cancelled: nothing was installed.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Canned cycles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Certain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chamfer along each side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chamfered rectangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Change of wait</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Change the programmed value while cutting, in percent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Changes of the job's own program since then</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Check a G-code file with the job's machine, stock, tools and clamps, and send it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Check and send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Check and simulate: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Checking against the machine…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Checking the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose a line, an entry of the list, or click a cut in the 3D view. Everything before it counts as cut; if unsure, choose an earlier one.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose a material: the chart then gives feed and kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose a port, or type an address.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose a port, then connect.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose above where to cut, then connect.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose another file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose one here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Choose the profile that is nearest to your machine, and enter its travel and speeds.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Circular pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close gaps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close the open task panel first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Close the safety door, then resume.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Closed lines around the area to face; without them the whole stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Columns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Come from above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Come from below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Commanded length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Comparing the cut with the drawing…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connect to a controller first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connect to the controller at this port.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connect to the machine first, in the controller's panel.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connected and idle. Take the tool out, or lift it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connecting…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connection lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Console</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Consumable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Containers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Containers of the clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contour that crosses itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contour {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Contours that cross</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Controller's buffer: {0} blocks and {1} bytes free</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Convert for this machine…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Convert units…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copies on the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copies that are placed by the search may be turned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copy of {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Copy…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner dwell</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corners that turn by more are cut slowly; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Correct the marked fields first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Counts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Crescent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Crest diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cross</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Currency</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Current</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut charts (*.toml *.cfg)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut in this order; unchecked operations are left out of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut it after the one below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut it before the one above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut off at the right angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut the solid into sheets and nest their pieces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting the part…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>D-hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Debounce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Degrees, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Degression</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Delete a point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Delete the marked tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth of cut ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Depth to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Details</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Device</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dial</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter and height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter at Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter cut away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of its middle line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the bolt circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the disc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the notches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter through the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dimensions</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Direction before step</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Discard</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect first: the dock is connected to this machine.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect from the controller.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance of both</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distances</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Does</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dog-bones</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Done</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Door</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Double D-hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Doubles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drag a part to move it, with Shift to turn it; Delete takes it away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drag knife</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drag parts in the view; with Shift they turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Draw a freehand line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Draw a line: press the left button, move, release. Shift: straight. Esc: end drawing.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Draw a part and cut it on a virtual machine, in seven steps. Nothing is connected.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Draw what is to be cut: a text, a shape, a sketch, a freehand line, or import a drawing. OK when it fits.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawing, solid or picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings of rests of sheets, which are used first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawings, sketches, shapes and operations whose outlines are nested</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drilling</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drive (steps per mm follow from it)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drive the length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Duplicate operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Dynamic power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>EPP foam</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>EPS foam</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Earlier</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edit program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edit {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Efficiency</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Elapsed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Enable before step</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Encoder (closed loop)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Encoder's gear</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Encoder's pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>End angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>End the search with the best so far</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ends joined</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ends of the legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ends that are nearer than this are moved together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engagement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engraving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engraving: a map along a point list</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Enter from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entering angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Entry slit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Every job with a journal was cut to its end.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Exit of the wire: back along its entry, or the shortest way to an edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Export job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Extra depth, so that the tool comes out below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Eye</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Eye plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Eyes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F is the feed per minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F is the feed per turn of the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F is the inverse of a move's time in minutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FR4 (glass fibre)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Facing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Failed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Family</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fastest spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Faults</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed and speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed at corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed of arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed of holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed per turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed without F</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feeding in air</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feeds by a factor…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feeds times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Figures</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>File</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>File…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fill the sheet of the chosen one, or the first, with the marked row</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Find</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Find the cause, then home the machine or unlock it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Findings ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Findings ({0}): the program must not be sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finds and replaces (Ctrl+F)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finish</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finishing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First eye</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First hole at</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First wait</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fit to drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fitting arcs…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flanges and plates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flood</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Floor diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Folder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Follow only the selected lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Font file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For a board that receives bytes: 0 to 3, or unused for a motor without an axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For a mill that does not cut over its centre; 0: 10°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For the forces; empty: they are not figured</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Force</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Form</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Forward</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Free length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Free to jog</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD runs as {0}, which nothing can be written into: this folder is outside, and stays with the next one.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks numba. All works without, but planning and simulating are slow.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No machine can be reached without.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No program can be made without.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. Some files cannot be read without.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the first hole, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the last hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the lines of the pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a cut to the edge of the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a folder…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a piece to the edge of the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From a zip…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From contour {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From hole to hole along X and along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From line {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From line {0}, the time that it is run: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From one to the next</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From one turn of the thread to the next</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From that wall towards the end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the base to the eye's middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the bore's bottom to the keyway's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the chuck's face to the finished end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the circle's middle to the slot's end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the edges to the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the middle of the circle to the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the middle to the point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the operation {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the place that was clicked, {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the work zero (G90), or from the point before (G91)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From there towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From tooth to tooth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Front edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Full steps a turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F{0} in/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F{0} in/rev</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F{0} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>F{0} mm/rev</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G-code files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G73 pecks, chips</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G81 straight</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G82 with a pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G83 pecks, all out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G98 clearance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G99 retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gap closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gaps up to this are closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gasket: cut out of sheet by plasma</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gear ratio</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>General</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go back along the cut by this length; a machine that moves is held first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go back to where the tool last began to go down into the work.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go back to where this line of the program begins, its last run before here.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go forward along the cut by this length, at most to where it was held.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go up to this Z first; where none is given: the program's highest crossing rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Goes back by</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Goes on with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Good side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Grain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest depth of cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest engagement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Grey values are from the chart; typed values replace them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Gusset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>H-profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>HDPE plastic</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Half the width of the pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Heart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height above the top of the stock; lines: where the tool's tip goes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height below the notch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the plate above the middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the teeth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Heights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Highest feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Highest speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Highest spindle speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hold</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hold: slow down and stop on the path; nothing is lost, the spindle keeps turning.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holder diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holding…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hole for the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes of a smaller diameter are cut slowly; 0: none by diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes of a smaller diameter get a spot at their centre, no cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes with a shorter outline are cut slowly; 0: none by length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Home</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Home the machine: it finds its zero with its limit switches.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Homing switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Homing works only while the machine is idle or in alarm.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hook</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hot wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep a knife or point goes; 0: through the sheet, a point 0.2 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep one peck goes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How deep one peck goes; 0: in one go</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How do you want to begin?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a bar or drill gets along Z, a blade along X; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a closed cut is followed with power beyond its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a closed line is followed beyond its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a drag knife's edge trails behind its axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far a pierce stays from parts and cut edges; 0: that of the cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far above it the letters stand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far an arc turns, or how far a line leans away from the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far apart joints are at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far apart tabs are at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before and behind a corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before and behind a corner the feed is lower; 0: it is not</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before its end the cut runs on without power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far before the material a rapid ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far behind the pierce the power is full</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far chords may leave an arc, where the controller has no arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far letters lean to the right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave other curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far lines and arcs may leave the pixels; 0: half a pixel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far one click goes along the cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far one click moves the machine.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far one turn of the helix falls</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the arc goes; below 0 clockwise, with the letters outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the axis goes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the cut may be off the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the jaws stand out of the chuck's face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the kerf of a way through the scrap stays from every part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the raw end lies before the finished end face, where Z is 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the tool's rim runs over the edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the torch runs on over the begin of the cut without power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the wall may be off the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How fast the axis goes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How fast the machine moves while jogging; it never goes faster than it can.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How high a tab is above the bottom of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How is {0} cut?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How it is cut; the machine must be able to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How it was read last</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How long a spot has power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How long the flame heats before the pierce; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many are wanted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many corners and narrow places the tool does not reach into</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many gaps, doubles, crossings and other faults were found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes along X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many holes are made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many joints on each outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many of each are wanted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many parts are cut free</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many seconds a denser nest is looked for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many tabs hold the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many tabs on each line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many teeth; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many there are</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many there are: one, or one a tool in turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many times faster than a real one the virtual machine moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many times faster than the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many turns the thread has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many; 0: those of the designation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the part is shown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the rim may be in the material at most, as an angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How often each line is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How often the tool pierces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply the tool goes down along the line; 0: straight down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the area is cleared</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the drill goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the thread winds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool comes to the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool is fed in from pass to pass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool leaves the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How wide a tab is at its top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How wide the material is that stays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Identity</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Import drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Import tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Import…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In front of the thread, where the tool catches up with the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In holes, or round bosses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In how many steps outwards</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In machine coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In the controller's panel choose a machine whose pulses this computer makes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>In whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inertia</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Infeed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Infeed angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inner diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inputs that are on: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inside of the hook</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Install</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Install from files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Install packages</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Install packages…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Installed. CNCStepper can work now.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Interpolation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Interval of pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Into which a boring bar fits; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Is the work zero set on the stock, and is the path free?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Isosceles triangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>It is cut first already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>It is cut last already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>It is your copy of a shipped profile, and is used in its place.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its code of ISO 1832, such as CNMG 120408; empty: by its angles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its designation: M20x2.5, 1/2-13 UNC, G1/2, Tr20x4</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its direction that lies along the grain of the material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its language and its link: grbl, grblhal, fluidnc, linuxcnc, thesis-a …</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its machine runs and checks the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Its name in job files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jaw diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jaws</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jerk</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Job: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jobs ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jobs and programs of the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jog</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jogging</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Jogging works only while the machine is idle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Join ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Join only lines of one colour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Joints that hold the part until it is broken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Junction deviation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keep as mesh</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keep cutting and close</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keep the cut part as mesh</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keeps the text where it came from (Ctrl+S); a job's is kept beside it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerning</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keyhole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keyway bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kind</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>L-bracket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Laser</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Laser (M4 with power)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last seen</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Later</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead-in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lead-out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leads</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leads as usual for the process, or with values of your own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Least wait</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leave out of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Left on the face for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Left on the profile, normal to it, for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Left out, it follows from the drive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length of the neck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length that the controller adds to Z, if the machine uses a table of lengths; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length, width and height; for an upright cylinder the length is its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Level</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Levels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lever</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lift before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Light areas</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line at release</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line by line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line {0}, {1}: {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line {0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines can be typed only while the machine is idle or in alarm.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines nearer than this to another one are drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines of many points become fewer lines and arcs within this; 0: they stay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines that are marked with low power or lightly scribed before anything is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines up to this long are left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Load {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Locking wheel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look at a finished job, change its numbers and simulate it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look at the cut part before it is cut, and at what the checks have found. Then close the panel.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look at the findings, then decide.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look at the machine, then connect again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look at the port, then connect again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Look-ahead</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Looking for a Python…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Looking for pip…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loop radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Loops in the scrap, which make outside corners sharp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lower right to upper left</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lowest speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M6, by the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>MDF board</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine test</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Made of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Major</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make a job first, with New job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make a job: it holds the machine, the size of the stock and the tools. OK takes what is proposed.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make shorter…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make this position the work zero of the axis.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Margin around the motor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marking feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marking power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material that a round tool leaves at the ends of the long axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Material that stays between two cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Measured</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mend</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Message</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Messages</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Method</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Metres a minute at the bar's diameter; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Microsteps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn of the spindle, where the operation says nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn of the spindle; 0: the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn that the insert needs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Millimetres a turn that the insert takes; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Milling</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Minor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mirror…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mist</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motion in air</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor (its torque is checked)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor of a null pulse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor steps: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor's power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motor's steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Motors</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mounting plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move a point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move for as long as an arrow is held down; letting go stops.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move the machine in this direction.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Moved by</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Moved mass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Moves, scales, turns or rewrites the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>NEMA motor plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>NEMA size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Name of the profile: letters of a to z, digits, - and _</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Narrow arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nest</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nesting the pieces: {0} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nesting: {0} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nesting…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Never farther off than, mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Next</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Next, in the controller's panel: connect, work zero, start.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No controller is connected.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No job is unfinished.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No job runs: there is no cut to go back along.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No messages yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No place is chosen yet.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>None</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nose radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Not certain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Not connected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Not sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Not used: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Notches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Note</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nothing changes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nothing moves that could be held.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nothing moves that could be stopped. The emergency stop is on the machine.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nothing was found: the program can be sent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nothing was installed.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nozzle, lens, wire or blade; empty: the first of the chart for this thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Number the lines…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Objects</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a parting blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a sheet of material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of each part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of its curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of its tip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the bores; 0: that of each circle of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the capitals, or of the em</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the corners seen from above; 0: as round as the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the cutting edges; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the driver, in a full step</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the font, such as Bold; empty: the regular one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the grid about its first hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the pulley that drives the belt</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the tip below the finished end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the tip; 0: that of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On its cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On which side of the cut the part lies, seen along it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>On which side of the lines the tool runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One end of the diagonal, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One hole at each point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One step back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One step is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One step on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open a G-code file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open an example</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open or make a document first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open pulse letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open the 3D view of the document first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Other corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Other diagonal (0: none)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Out of the hole for each peck, or to break the chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outer diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outlines of the clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outputs during a retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outputs that are on while cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outside corners that turn by more get a loop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Oval flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Over-burn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overcut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overhang</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overlap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overrides</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Overrides work only while the machine is idle or cutting.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Oxyfuel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>POM (acetal)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>PVC foam board</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>PVC, rigid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pairs of letters stand as near as the font says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parallel port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parallelogram</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts and signs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts of a larger number are placed first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts on all sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts without a place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Passes along</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pause between pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pause of the wire where the path turns back; shorter at blunter corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Paused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Peck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Picture</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce delay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierce height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pierces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pin {0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pins of the parallel port; a minus sign is active low</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pixels an inch; 0: as the file says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place all</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place all copies that are not locked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place all parts that are not locked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Place of the mirror, mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Placed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Placements</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plasma</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plate: holes, pockets and a contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Play or pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Please report it, with the details, at {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Point angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Points of the pull-out curve, rpm and Nm: 0 1.2; 300 1.0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Polygons</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Port's address</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Position</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power (M3)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power on before the tool moves; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Power ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Preheat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Preset speeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Preview</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Previous</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Price per hour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Price per metre cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Price per m² of material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Price per pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Price per sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Problem</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Processes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Profiles (*.toml)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Program: {0}, in the editor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Programs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Programs ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pull-out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulley's teeth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse letters ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse letters: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses +</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses −</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulses/s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Put into the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Put the stock around the selection, or around the drawings of the operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Quarter turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius in pixels of a blur that takes out noise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius of the inner corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius of the inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius x</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramp length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ramps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rapid speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ratchet wheel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reach</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reached</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Read the file again; operations keep their contours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reading the drawing: {0} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reading the drawing…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reading the job…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reading the program back…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reading the program…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rectangular pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Refused by the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Region</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Registration holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Regular polygon</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Relays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Relays and inputs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Relays are switched by hand only while the machine is idle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Release to close the line. Esc: give up this line.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reload</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reload {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remaining</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remnants</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remnants: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remnant…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remove</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remove tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Removed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Repair</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as the values under Repair allow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Repair what is wrong, as far as these values allow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Replace</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Replace with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Report</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rest corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart from here…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart the program at a line, an operation, a contour or a place in the picture.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart the program at the present line; everything before it counts as cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Restart…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Result</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resume after a hold, a pause or the door.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reverse (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reverse the contours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Revert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Right hand cuts towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ring</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ring sector</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rotate…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Round shapes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rules</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Running</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>S is the speed at the surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>S is turns per minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>S-curve</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Save</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Save and go on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Save program as…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Saved {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Scale…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Screw</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Screw speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Screw's pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Scribe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Search time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Second eye</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Second hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Seconds at the bottom</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sector</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Segment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select a drawing in the tree or in the 3D view first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select a drawing or a solid first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select one or more operations in the tree</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select one or more solids first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select operations of one job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the area to clear: a sketch, closed wires, or faces of a solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the drawing in the tree, then choose how it is cut: engrave it, clear it as a pocket, or cut along its contour. OK when the depth is right.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the job in the tree: this document has several</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the lines to cut: a sketch, wires, or faces or edges of a solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the lines to engrave: a sketch, a wire, a B-spline or a freehand line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send a G-code file…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send anyway</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send it. Leave the port on 'Virtual grbl (no machine)' and press Connect: nothing can break.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send this restart…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sent ahead at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Set up my machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Setting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shaft: turned on a lathe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shank</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape of the raw material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shapes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet, X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet, Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of material that the pieces take</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets of the stack</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheets that carry parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shield</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shorter than</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Show how far the last unfinished job came, and restart it there.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Show the tool's path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shows the same program as this machine's controller reads it: M6 becomes the machine's tool change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Side along X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Side along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sides</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sign: letters, a pocket and an outline with tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Signals and pins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simplified</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simplify</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simulate again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simulation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size of square and circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slices</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slicing…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slots and holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slower than published</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Small holes at a feed of their own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smaller areas, in mm², are left out; 0: four pixels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smallest bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solids that the tool must not touch; findings name them by their number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Specks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spin-up time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle and relays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: by the surface speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: that of the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute; 0: those of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot holes below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spot time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spring passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Square</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Square flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Squareness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Star</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start/stop wait</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Starting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Starts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>State</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Steepest ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Step ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Step times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Step {0} of {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stepper motor (open loop)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Steps of the ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Steps per mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Steps/mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock to leave at the wall for another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stop the cut and close</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stop: slow down, stop, spindle off; the rest of the job is not cut. This is not an emergency stop: the emergency stop is on the machine.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stopped</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stopping…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Style</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Surface speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Switch it on or off.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Switch {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>S{0} clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>S{0} counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>T-bracket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>T-slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tag</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tailstock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take into the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take selected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the chart's value again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the chosen part from its sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the dial's reading from both sides first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the line numbers out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the marked rows out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the marked rows out of the nest</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the solids that are selected for clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Taken out, drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Taken out, tiny</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Taper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Teeth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The G-code file that it is, which has nothing to do with the operations of its job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The angle between X and Y is {0:.4f}°: {1:.3f} mm over a metre.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The axis of each motor in order; -y is mounted the other way round: x y -y z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The baud rate of the serial port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The checks found errors: nothing is sent. Mend them, then send again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The checks found errors: this restart must not be sent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The circles and points of sketches, or the circular edges of solids</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The clamps seen from above, at the height of their tops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The colour in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The connection is being made.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The connection was lost during the test.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The controller does something that was not asked for here.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The controller is set up differently. Nothing was sent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The controller's panel is attached again to a machine that was left connected.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The controller's settings are compared.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The corner where the grid begins, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The current set at the power source; 0: from the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The cut chart gives this value; change it in the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The cut is simulated and checked.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most, on the radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of the first pass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter at the other end of the flanks; 0: that of a metric thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter at which the cut ends; 0: over the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of a boring bar; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the centre hole; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the floor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the raw bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the surface into which it is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the tailstock's centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the tool holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the back edge away from the nose, from Z+ towards X+</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the front edge away from the nose, from Z+ towards X+</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The direction of the material's grain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The document and the name of the object itself; a copy still has those of its original</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing gives this value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing that the objects follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The edge of the sheet at which the wire enters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of a program without F, and the cutting speed of a language without F</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of marks; 0: that of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass; 0: the tool's own feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the program, in millimetres a turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The file has a new layout: its comments are not in it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The file of a cut chart of your own; empty: the chart that ships</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The fingerprint of the job's program from which this one was edited</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The first line that is not certainly cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The flat at the tip of a V-bit or engraver; 0: it is pointed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The groups around it in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The half profile that it turns: a sketch, edges, a solid or points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The half profile whose diameter the thread has; without it the usual fit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The height of the rapids between holes: G98 or G99</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The inner diameter of a tube</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job continues without FreeCAD; the controller's panel shows it when it is opened again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job is being cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job that did not end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job waits on its cut. Resume cuts on from there.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job with the machine, stock, tools and clamps for the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The last job of this machine, {0}, was not cut to its end. Unfinished job… shows how far it came.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The layer in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of all cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the file's unit; 0: as the file says, or as its program usually means it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the lead's line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length over which the tool comes out at the end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length that the part keeps, below zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The letters start at the machine's position.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The limit of the surface speed; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The link to the controller is being started.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is at rest and waits.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is at rest; nothing is lost. Resume or stop.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is cutting a job.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is made free to jog while a job is held.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is moved by hand.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is not held: there is nothing to resume.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is not in alarm: there is nothing to unlock.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine looks for its switches.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine must be idle: wait, or home or unlock it first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine slows down, then the job is ended.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine slows down.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine waits before each line of a job; Resume cuts the next one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine with the dialect in which the program is read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine's position is unknown: home it, or move the tool to the work zero and press All = 0.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine's position is unknown: stop the job, then home the machine or set the zero of all axes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The marked solid is no clamp any more; it stays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The middle of the circle, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The mini-lathe's link</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The minor diameter that is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The name in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The nominal diameter; 0: that of each circle of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The operations, in their order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The order in which the holes are made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The order in which the lines are cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The other end of the diagonal, before the rectangle is rotated</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The outline seen from above, or the faces or the section at a height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the drawings move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and the values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The path of the last job is read…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The place of the work zero in this document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The place of the work zero on the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The place on the cut is being looked for…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The places of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The plunge feed of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The position of the table is unknown: home the machine, or set the work zero again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The profile has a value that is none: mend it first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The profile of the machine at this port: its relays, and how it is driven</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program has changed since: the view shows the earlier one.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program has changed: it is read again.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program is being checked with this work zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program is checked again, with the work zero that the machine has now.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program that is shown, checked and sent, if the machine needs one for each tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program waits; Resume continues it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The programs and their places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The radius of loops at sharp outside corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The radius of the lead's arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The restart is made and proven…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The retract along the cut is being calculated: wait, hold or stop.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The retract along the cut is being checked…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The rotations in which it may lie</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The section of a beam, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed there; a slower wire melts a wider kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the feed with which they are cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The share of the power at the pierce</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wires or faces to cut: closed lines are parts and holes in turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The sketch, wires or faces to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The solid and the values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of cutting moves; 0: that of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of rapids, where the language leaves it to the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of the cut; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed straight down; 0: that of the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speeds that a gear or a switch has, rising; none where any speed can be set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The spindle's speed in the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The test is under way: wait, or stop it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest chip that a tooth bears; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest material left in inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thickest material left in them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool can retract along exactly the path by which it came.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool goes back along its cut while a job is cut, or is held.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool goes forward again only after it went back.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool is at the end of the cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool is on line {0}, at the end of the cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool is on line {0}, {1} behind the end of the cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool moves along the cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool's X when the program begins, as radius or diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool's Z when the program begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The torch above the sheet while it cuts; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The torch above the sheet while it pierces; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The waits between steps from rest, in ms, none longer than the one before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The wall towards the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut where it is not the chart's; 0: the chart's, else the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut where it is not the tool's diameter; 0: the tool's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the cut; 0: that of the cut chart or the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of the picture; 0: as its resolution says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The work zero can be set only while the machine is idle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The working plane is seen from its edge: turn the view to draw on it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Their diameter; pins through them align the sheets; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>There is no restart to send yet.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>There is nothing that fits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>These profiles have changes that are not saved: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness of the flanges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness of the web</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This card does not come again by itself: it is in the menu CNCStepper, First steps.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This is cut by: {0}. The job's process is: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This machine has no axis Z.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This machine has no homing switches set up ($22=0).</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This needs a number without a unit, not '{0}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Three quarters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Threshold</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Time in the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Time of the tool at rest with power; 0: from the cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Time that it is run</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Timing the moves…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tiny</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tiny contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tip orientation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To the begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To the end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To the entry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>To the start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tolerance of the cut line, which reduces the number of moves; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool tables in inches ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools without feeds or speed use its table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Toothed belt</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Top diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Torch off before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Torque at speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Trace what is light instead of what is dark</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Trapezoid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel for a turn of the screw; with several starts its lead</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel of the motor at a reversal before the axis moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel per turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Travel to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Triangular plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Try without hardware</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turn the chosen part to its next rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turning</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turns of the encoder for one of screw or pulley</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Turns of the motor for one of screw or pulley</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Twice from the middle to a side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two eyes and the bar that joins them along X; the first eye's hole is at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two flanges that an offset web joins, its left lower corner at the zero; a hole in each flange.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two legs up from a base, the zero in the middle of the base's lower edge; a hole in each leg.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Type a line: $$, $#, G0 X10</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>U-bracket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unfinished job…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Units</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unlock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unlock the alarm without homing: only if the position is certainly right.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Use a drawing of a rest of a sheet first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Use the tool of the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Use whole sheets only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>V-bit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Virtual grbl (no machine)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Waiting for the controller to answer.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Waiting for the cut…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wall feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Warning</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Watch it cut. Hold stops the feed and Resume goes on; Stop ends it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Water jet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What becomes one object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is cut into sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is one step, on or back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is written; several lines are set below each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the X of a row is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the height is measured of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the insert takes, on the radius; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the letters stand on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the program's X is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the tool is for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was found in it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What was read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where along the axis the diameter is read; a click on the part sets it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where it begins; 0: that of the profile or the usual fit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the arc begins; counter-clockwise from X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the copies lie</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the drawings are written; empty: beside the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the face lies when it is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the line begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the line ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the parts lie</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the program is written; empty: beside the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the row begins, from the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the row ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the text stands about its zero, or on its line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the thread begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the tool is when the program begins: clear of the raw end, or given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a centre holds the raw end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a laser's power follows its speed (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether a slit through the part leads the wire into a closed hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether all of its chains are closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether form, kerf and feeds are those of the job's cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether inner corners are opened, so that a square corner fits in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether it works in a bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the depth is that of the point or of the full diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the file fills it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the file is as it was read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether their directions are those of insert and holder, or given by two angles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whether threads are written as G76, where the controller has it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>While pressed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Whole part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of each flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the bars</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the ears</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the mouth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the shaft</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wing rib: out of foam by a hot wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wire cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work out the angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Write program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Write the one checked program of all copies</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writes the text into a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writing the program…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writing the report…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X words are diameters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X words are radii</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X, steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X; Y in {0}, one hole a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X; Z of each point from the end face to the chuck; then chamfer, fillet, cw or ccw</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>XPS foam</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Y times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Y, steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Your first part is cut. A real machine goes the same road: set it up under Machines first.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the faces or of the section</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z of the wall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z, steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Z-bracket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Zip with packages ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a comment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a file for each tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a parameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>absolute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>absolute (G90)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>acrylic, cast</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>active low</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all stand out equally</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>along X (as G72)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>along Z (as G71)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>along the flank</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>along the profile (as G73)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>along the walls</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>alternating flanks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>aluminium</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>aluminium 6061</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>and {0} more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>angle about X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>angle about Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>angle about Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>any</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>applies a given tool length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>applies the tool's length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc centre along X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc centre along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc centre along Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc centres are absolute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc centres are seen from the arc's begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc, clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arc, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs lie in the XY plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs lie in the YZ plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs lie in the ZX plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs within the tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>as drawn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>as given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>as the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>as the thesis published it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at a height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at the lower end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at the upper end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>automatic</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>back along the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>back along the entry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash {0:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ball end mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bolt circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>boring</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bounded engagement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>brass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bull nose</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>by contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>by layer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>by two angles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>calls a subprogram</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cancels G92</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>canned cycles return to R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>canned cycles return to where they began</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>carbide</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>carbon fibre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cardboard</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cardstock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>centre of the top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>changes the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>click on the part, or type a Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>climb</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>constant acceleration</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>conventional</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>coolant off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>coordinates are absolute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>coordinates are steps from where the tool is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>copper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cubic spline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cuts a thread in several passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cylinder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>depth of a peck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>digital differential analyser</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drills</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drills with a dwell at the bottom</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drills, breaking chips</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drills, lifting the chips out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drives enabled</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>dwell for P</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ends the canned cycle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>engraver</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>exceeds the machine's travel; at most {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>felt</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>first of the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flat end mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood (M8)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood on/off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>foam</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>foam board</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>follows the path exactly</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>for the command line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>front</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>front left corner of the top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>full diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>glass</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes far beyond the machine's fastest axis; at most {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes far beyond the stock and the machine; at most {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes far beyond the stock; at most {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes to the first stored place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes to the second stored place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>granite</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ground</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>hardwood</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>heat transfer film</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>helix</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>high</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>high-speed steel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>how often, or which</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>inches (G20)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>incremental</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>incremental (G91)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>input</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>into one side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>into the corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>inverse time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jet (water, plasma, laser)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leads the program elsewhere</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leather</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lengths are inches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lengths are millimetres</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>limit switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>limit {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {0}, column {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lines in one direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>locked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>low</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make room in the folder for temporary files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mild steel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>millimetres (G21)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist (M7)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist on/off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>moves in step with the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be 0, or at least {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be above {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be at least {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be at most {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be below {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>names the present place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nichrome wire, 0.4 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no cutter compensation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no errors</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no material there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no tool length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is marked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing to correct</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>numba makes it fast from the next start of FreeCAD on.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>number of the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>number of the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>number of the tool for compensation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>number of the tool length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>of a drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>of the insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>off when pressed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>offsets from a table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>on the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>on when pressed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>open a document or its 3D view</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>open one and simulate again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>our planner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>out of the hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>outlines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>output</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>output 0 (M64 P0)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>output 1 (M64 P1)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>output 2 (M64 P2)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>output 3 (M64 P3)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>own values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>paper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parting and grooving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pause, by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pauses if optional stop is on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pauses until cycle start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along U</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along V</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along W</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place along Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>plywood</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>polycarbonate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>probes away until the contact opens</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>probes away until the contact opens; otherwise an alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>probes until it touches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>probes until it touches, an alarm where it does not</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>profile: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>published points (DDA)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulsing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>quadratic spline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radial</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radius, or where a canned cycle begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rapid: straight, as fast as the machine can</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raw surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rear</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>returns from a subprogram</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rounds corners off to keep its speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rubber</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>safety door</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sandblast film</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sets offsets or tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shipped; your first change makes a copy of it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>short rapids</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>softwood</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spacing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>speed of the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle on, clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle on, counter-clockwise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle reversed (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle stop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle, torch or beam (M3)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spiral</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stainless steel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stay on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>steps per mm {0:g} becomes {1:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>straight cut, at the feed F</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>straight down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch by lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>table of step times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the capitals</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cutter runs left of the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cutter runs right of the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the em (font size)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the nearest edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the one that ships</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the whole stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no 3D view to draw in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this document has no 3D view</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this line is in machine coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this line is not run</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>threading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>time, number or turns, as the code has it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>titanium</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to break the chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to make programs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to nest parts on sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to plan and simulate fast</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to reach a machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to read and write files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to the nearest edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tube</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turning outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>usual</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>usual for the process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>usual: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>value {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>vinyl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>work zero {0} of 9</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write points as: 0 1.2; 300 1.0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>yours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>zero set with each tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>zigzag</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} (deleted)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} (edited)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} (single lines)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} = 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} does not name this process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} errors</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} from below, {1} from above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has changed in the document; your typed values are kept here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has changes that are not saved.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has changes that are not saved. They must be saved before it is checked or sent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has nothing to cut: add an operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is as its file again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is cut with it; choose another tool there first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is no operation and is not moved</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is written.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is {1} now: save it.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} lines change:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} more contours: choose them by line, or in the 3D view.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} of {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} of {1} lines, line {2} of the file, sent to line {3}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} on layer '{1}' at X {2} Y {3}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} on layer '{1}' was left out: {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} parts on {1} sheets, {2} missing; the sheets are used to {3} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} readings: mean {1:.4f} mm, standard deviation {2:.4f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} replaced</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} slices, {1} pieces on {2} sheets of material; volume {3} % of the solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} stays in its job: drop it on another operation, or on the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} stays in its job; copy and paste it into another document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} step</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} tools imported</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} was not cut to its end, and no open document has the program that was sent.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} was opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} was written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} ×</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} × {1} mm, layers: {2}, open contours: {3}, the file's unit: {4} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}, cut until {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}, line {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}, restart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}. Now {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}: X {1}, Y {2}, {3}°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}: its file has changed; Reload in the tree takes it anew</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}: its file is not there any more; what was read stays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}: {1} points, within {2:g} mm of the drawn line. Draw the next one, or Esc: end drawing.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}× speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>… and {0} more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>… and {0} more lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>⌀ {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>⌀ {0}, bore ⌀ {1}</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper core</name>
        <message>
            <source>! is a command to the controller (feed hold), not part of a program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>#&lt;{name}&gt; has no value here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>${number} is {value:g}, wanted {wanted:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>% may stand only alone on a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>% may stand only on the first and the last line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'cncstepper drawing' prints its layers and colours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{axes}' names no axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{code}' is no insert of ISO 1832</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{designation}' is no designation of a thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{drawing}' has more than one solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{drawing}' holds no lines that can be followed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{drawing}' is a solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{drawing}' is no profile by points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{drawing}' is one more drawing beside '{used}', and only one gives the shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{each}' is no operation of '{job}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{file}' is no kind of sheet that can be written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{inner}' and '{outer}' cross, so that it is not clear what lies inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{insert}' is no insert of a {kind} tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{key}' cannot be {value!r}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{label}' does not lie in a plane through the lathe's axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{label}' has a hollow that no tool can enter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{label}' is drawn where '{other}' is, and counts once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{label}' is no solid of revolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{line}' is no block that only switches, as M8, M3S9000 or M64P0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{line}' is no row of a profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{name}' holds no lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{name}' is no name for a machine profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{name}' names no port number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{obj}' stands on this job and cannot be its clamp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{origin}' is no origin of a stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{out}' is drawn where '{kept}' is, and counts once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{part}' in '{line}' says nothing of a corner or an arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{path}' is no tool file that is known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{solid}' is no solid and cannot be a clamp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{text}' is a move whose end only the controller knows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{text}' is no tool of a lathe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{text}' is not a tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{value}' is no feed for programs without F</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{words}' is no length or angle that is known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{word}' changes no key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>(begin operation: {0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>(finish operation: {0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>(nu=7, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>(program {number} of {count}, tool {tool})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>({0}: {1} stretches arranged)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>/ (block delete) may stand only at the beginning of a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0 to {most}, or -1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0 to {size_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0 without an entry slit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0.005 mm apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0.87 times the width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>00 to 99, in tenths of a mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>= is missing after the parameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>? is a command to the controller (status), not part of a program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>@ and ^ lie in the plane XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>@ and ^ stand for X and Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A bar above and a stem below, the zero in the middle of the bar's upper edge; three holes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A bore about the zero with a keyway above (DIN 6885: bore and key's depth over all).</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A circle about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A cross of two bars about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero less another one beside it, like a moon.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero with round notches in its rim and a bore.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A disc about the zero, cut off straight above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A drop: a disc about the zero and a point above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A flange of two bolts along X: a disc about the zero with an ear on each side.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A heart of two half circles over a rounded tip, the zero in its notch.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A hole to hang a part on a screw: a circle about the zero for its head, a slot above for its shank.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A hook to hang things on: a plate with two holes above, the hook's round inside about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A label about the zero: round corners, cut off on the left, with a hole for a string.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A parallelogram, its left lower corner at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A piece of a ring about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate about the zero for a stepper motor of NEMA size 8, 11, 14, 17, 23 or 34.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate about the zero with an eye and a hole at each of three corners.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A plate to hang a load: a base below, an eye about the zero above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A polygon of equal sides about the zero, one side below; the size is across the flats.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangle about the zero with its corners cut off at 45°.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangle about the zero, its corners sharp or round.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A rectangular plate about the zero with a hole near each corner.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A right-angled stiffening plate, its right angle at the zero, cut off there to clear a weld.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A ring, or a washer, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round flange about the zero with a bore and a circle of bolt holes.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round hole with flat sides above and below, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A round hole with one flat side above, for shafts with a flat; about the circle's middle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A shield, the zero in the middle of its upper edge: straight sides, round below.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slice of a disc about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slot in the edge of a plate for a bolt's head: open below, the zero at its mouth's middle.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A slot with round ends along an arc about the zero, from X counter-clockwise.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A square plate about the zero with a bore and a hole near each corner.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A star about the zero, one point above.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A straight slot with round ends along X, about the zero; the length is over all.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A trapezoid, the zero in the middle of its base.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A triangle with two equal sides, the zero in the middle of its base.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A wheel about the zero with saw teeth and a bore.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ATAN needs a second value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Across the flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Across the flats</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Adobe Illustrator</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>An angle of two legs, its outer corner at the zero, a hole near the end of each leg.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>An arrow along X, its tip at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arc slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bluetooth could not be started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Bore; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper batch journal</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper certificate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper journal</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper report</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CadQuery or FreeCAD</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CadQuery or build123d</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chamfer along each side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Chamfered rectangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut off at the right angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>D of {code} is the number of a tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>DejaVu Sans</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>DejaVu Sans Mono</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>DejaVu Serif</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter cut away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of its middle line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the bolt circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the disc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the notches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter of the points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter through the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance of both</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Distance of the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Double D-hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drag knife</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>EXISTS asks for a parameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ends of the legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Eye plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fetching {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fetching {name} ({size})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First eye</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>First hole at</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Flanges and plates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD has no stock of a height field</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD has no tool bit for a {tool_shape}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {lacking}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the base to the eye's middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the bore's bottom to the keyway's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the circle's middle to the slot's end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the edges to the holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the middle to the point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G10 L{kind} changes nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G10 is read with L1, L2, L10, L11 and L20 only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G28 and G30 may not be used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G28 homes a Marlin machine: home it before the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G28.1 homes a Mach machine: home it before the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G43.1 may move only the tool-length axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G43.2 takes H, and a line with it takes no axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G5 needs both I and J or neither</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G5 needs both P and Q</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G5.3 ends a NURBS: no other motion may share its line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G5.3 without a G5.2 before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G52 moves the zero about which the path is changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 and G28 have no place in work coordinates: give the work zero, or take them out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 may not be used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 needs a G0 or G1 move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 takes X and Y only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 takes absolute coordinates only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 works only with G0 and G1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G64 P lets the machine cut corners: times and pulses do so, the simulated part shows the programmed path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G64 without P does not say how far the machine may cut corners; all is worked out for the programmed path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G76 moves X and Z only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G80 leaves no motion for the axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height below the notch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the plate above the middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Height of the teeth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hole for the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Holes; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hot wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>I of G76 may not be 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>I of {name} must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>I, J and K are given from the start point of the arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>IJK distance mode changed to absolute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>IJK distance mode changed to incremental</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ISO 6983 has no such word: leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inner diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Inside of the hook</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Isosceles triangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>J and R make too many passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>J of G76 must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>K of G76 must be above J</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kerf test: S = {0} mm, kerf used {1} mm. {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Keyway bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>L may not be negative</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length of the neck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Liberation Mono</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Liberation Sans</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Liberation Serif</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>LinuxCNC with QtPlasmaC</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Locking wheel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M3 starts one tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M6 depends on the machine's configuration: pause with M0, or split at tool changes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M66 takes either P, a digital input, or E, an analogue one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M66 with L waits: it needs Q above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M98 needs a P word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>M98 takes one P and one L</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mach probes with G31</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine profile, made by CNCStepper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Margin around the motor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marlin has no end word (M30 deletes a file): leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marlin means something else with it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Marlin would read G91 or G90: leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Mounting plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>NEMA motor plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>NEMA size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>NOT simulated on a stock: the machine's limits are checked, but not whether a rapid meets material; give --job, or --stock and --tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nested parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nimbus Mono PS</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nimbus Roman</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Nimbus Sans</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>No module named pip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>O-words are nested too deeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>O-words work only in a macro of the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>O-words work only in a macro on the controller's card</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>O1234 ends with M99</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>O1234 is called by M98 P1234</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Outer diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Oval flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>P of G04 is seconds on some controls and milliseconds on others</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>PID eq {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Parts and signs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Q asks for too many pecks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Q of M19 must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC changes feed and end of small holes itself: that is not in this reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC cuts a tube, with the program's own moves of Z: they are not in this reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC has no key {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC keeps the program's own moves of Z: they are not in this reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC moves Z itself: arcs are in XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>QtPlasmaC pierces only and cuts nothing: that is not in this reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>R lies below {normal}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius of the inner corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius of the inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ratchet wheel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Regular polygon</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reset to continue</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ring sector</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Round shapes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>SIGTERM lets its process stop the machine safely</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Second eye</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Second hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>SetThreadExecutionState was refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slots and holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Speed test {0} of {1}: {2} mm/min, {3} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Square flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>T selects an extruder: pause with M0 where the tool is to be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>TLS takes an authority, a certificate and its key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The section of a beam, about the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness of the flanges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thickness of the web</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Times New Roman</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Trial {0} pulses/s late mean {1} us worst {2} us</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Triangular plate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Twice from the middle to a side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two eyes and the bar that joins them along X; the first eye's hole is at the zero.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two flanges that an offset web joins, its left lower corner at the zero; a hole in each flange.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Two legs up from a base, the zero in the middle of the base's lower edge; a hole in each leg.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Water jet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of each flange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the bars</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the ears</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the mouth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the shaft</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Width of the slot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writing {count} packages</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X goes past the centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>X is the {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>[ is missing after {keyword}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>`$` lists what the controller knows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>`cncstepper check` checks a program without the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>`kill {process}` (SIGTERM) lets its process stop the machine safely</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a G code has one decimal at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a G92 is in force where the tool is changed: a new program cannot rely on it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a JSON of the first release, and too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a NURBS of order {order} needs as many control points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a P or L value is missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a `%` is neither at the begin nor at the end of the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a bar of {diameter:g} x {length:g} mm holds no material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a bulge is not that of an arc in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a canned cycle moves X, Y and Z only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a canned cycle takes no inverse time feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a chip load needs flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a collection of {0} faces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a comment is closed that was not opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a comment may not hold another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a control pin was active at start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a control point needs a weight P above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a control point needs both X and Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a controller with a firmware of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a coordinate is not a length in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner has a chamfer_mm or a fillet_mm, not both</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner is either rounded (A) or broken (C)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner of the mesh is no number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner of the mesh is no number in bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner of the profile is too small for its fillet or chamfer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a corner radius of {radius:g} mm is too large for a side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a curve needs at least two points and a bulge for each segment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cut chart holds [[cut]] tables and nothing else</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cut goes into stock while the spindle is off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cut of the arranged program lies elsewhere, or has another feed, spindle or tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cutting move begins at an unknown position, so it is not checked against the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cutting move has no feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cutting move has no feed rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cylinder is as long in X as in Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a device on the Modbus does not answer as it should</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a difference of {slack:.4f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a distance must be a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a dog-bone would be too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a drawing of that name is there already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a drawing's unit lies between a nanometre and a kilometre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a drill cannot cut along a contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a drill goes sideways through stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a face of '{label}' does not run round the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a face's normal passes the axis by {passed:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a fault of the program: {kind}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a feed of inverse time (G93) cannot stay where the axes are scaled differently</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a feed per revolution needs a speed of the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a feed would become 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a file that calls this machine's position unknown belongs to {user} and cannot be opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a glyph calls too many subroutines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a glyph has too many parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a glyph has too many segments</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a height field needs two rows and two columns of finite heights at least</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a helix needs a known start point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a hole lies in no outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a hole would reach beyond its outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a hundred turns are enough</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a job runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a job runs, and the machine is not at standstill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a jog needs a way and a feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a lathe has no cycle '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a lathe tool is compensated in the plane ZX</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a lead of kind 'arc' needs radius_mm, and no length_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a lead of kind 'line' needs length_mm, and no radius_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a lead or a cut goes through a part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit or door is on a pin with a number, without port: on the machine's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch is pressed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch is pressed; only homing is allowed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch stayed pressed after homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch was hit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch was hit while probing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a limit switch was pressed before homing, and which one is not clear</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line does not fit the controller's buffer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line holds one command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line holds {count} M codes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line in '{label}' is open and encloses nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line needs at least two different points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line number begins with a digit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line number is written in digits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line of a parameter file is the number of a parameter and its value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line of a tool table names one tool, and no other line names it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line that begins with $ is a setting or command for the controller, not part of a program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line that changes the tool does more than that</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line that runs at every start moves the machine while nobody watches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a line with G80 takes no axis words, nor those of G43.1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a list has no entry {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a list of glyphs is longer than its table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a machine is cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a macro has stopped with an error of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a margin of {margin_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a material file has no {key}: left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a material file holds no rows of {process}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a material number is used twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a mesh and no line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a message could not be sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a mill that does not cut over its centre ({tool}) goes down into stock too steeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a motor driver reports a fault</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a move would end outside the travel (soft limit)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number beyond {most:g}: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number beyond {most_count}: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number is missing or cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number is out of range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number of hundreds of digits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number of the table is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number of thousands of digits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number that names something is short</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number that no letter begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a package that is to be replaced is in use</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a parallel port has 25 pins, and one below zero is active low</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a parameter could not be set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a part must have a length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a part of another operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a part or a value has changed since the parts were nested</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a path has no length, or a coordinate that is no length in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a path is mirrored along X or Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a path is too long for its tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a pattern has at most {0} characters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a picture and no line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a piece {length:.3f} mm long comes off the bar here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a pin in the configuration is wrong</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a pin with a number has a port: the device file of its parallel port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a pipe (FIFO)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a place before the begin of a table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a point is too far away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a probe or an input sets it on the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a probe takes no feed per turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a process of our own cannot be started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a process of ours has a machine's port, but its file {path} cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a profile is made of edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a profile must be one chain of lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a profile needs points or dxf, one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a profile needs two points or more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a profile's ends have no corner to cut and its begin no arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program for {language} cannot be restarted in its middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program of the mini-lathe begins at the work zero and cannot be entered in its middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program on the controller stopped at an error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program or a value has changed since they were arranged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program that goes to machine positions cannot be placed beside others</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program that sets or chooses a work offset cannot be placed beside others</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a program with subroutines, loops or branches is not rewritten</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a quarter of the width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid crosses the sheet, which a wire cannot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid crosses the stock with the beam on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid goes sideways while the height is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid goes through stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid goes with the power on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rapid with the tool running is not above all cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rate is more than nothing and less than a thousand million</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rate is tried at rest only, not in state {state}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a record was refused: reset first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rectangle's corner radius must not exceed half of its shorter side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a report of the controller is damaged and was not believed: {report}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a request without the session's token</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rotation of {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a rule has one of operation, marks_for and ignore = true</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a scale must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a scale must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a scheduler on another computer is asked over TLS only: what it is sent and sends is code</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a session's file belongs to {user} and cannot be opened, so that its port is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a setting asks for more steps a second than the controller can give</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a shape of the pattern is no circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a share is at most the whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a signal lasts between 10 ns and a second</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a single axis may not be homed here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a spline moves X and Y only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a step comes between every microsecond and every minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a step is between a nanometre and 100 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a strip must be the only sheet of an order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a subroutine in another file moves: it is not edited with the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a subroutine in another file sets a feed: it is not edited with the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a subroutine may not be defined inside another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a subroutine takes {arguments} arguments at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a symbolic link of another user in a folder that everybody may write to is not followed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a template has no key '{key}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a text is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a text needs one of font, file and single_line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a text runs along a line, an arc or a shape: give one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a text runs along one curve, but the shape '{shape}' has several</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a text runs along the shape '{shape}', which does not stand before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a thread is cut with a threading tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tolerance must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tool bit is one tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tool change is pending, and this command must wait for its end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tool length lies along Z only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tool length of {length:.3f} mm is in force, wanted none (G49)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tool of the library has no number nr or no path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thick a chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thick a chip for tool and material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tooth of the {tool} tool takes too thin a chip: it rubs and grows hot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a transform must not collapse the curve</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a turning tool needs insert, for example "CNMG 120408", or front_deg and back_deg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value in the expression does not fit its operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value in the expression is too large or too small</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is larger than the controller allows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is negative where only positive ones are allowed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is outside of its range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is zero or negative where only positive ones are allowed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a variation that is not there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a whole number from 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word does not begin with a letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word has a value that it cannot have</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word is a letter and a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word is twice in one line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {kind} tool has no insert of ISO 1832</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {kind} tool {verb} {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {shape} does not cut from the edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {shape} tool has no {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {tool_shape} cuts through at any height: no tabs, no ramp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {tool_shape} tool does not drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {tool_shape} tool leaves no flat floor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {tool_shape} tool mills no thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {what} needs one of {ways}; it has {told}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0 and below the least</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0 mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0, at most {ramp_max_deg:g} deg, no tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0, below {diameter_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above {highest_cut:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>act = "switch" and line belong together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add F, or write G94 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add G0 or G1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add closed = true to the rule, or mend the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add control points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add jobs, programs or files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add one before the first cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the missing pass, or lower the stepover or the stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the missing pass, or state the stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the tool or correct the T word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add what it is to set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add yourself to its group (sudo usermod -aG dialout $USER) and log in again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add {key} = and its value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add {letter} to the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>after a stop the first move names all its axes, on one straight way: let the machine stand above the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all before line {first_line} is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all of it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all {total} lines are cut, the machine is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an O-word begins a line of a whole program, in dialects that have them: here it is not read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an analogue input is only read, with L0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an angle between two sides lies between 0 and 180 degrees</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc by radius may not end where it starts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc in the plane {plane} would be no arc any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc needs a known start point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc needs arc = "cw" or "ccw", and radius_mm or centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc needs radius_mm or centre, not both</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc of another plane than XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc of several turns cannot be sent to a controller of this computer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc scaled unevenly is no arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc takes either R or a centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an arc without numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an axis is missing: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an edge of the solid is no curve: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an edge of the solid is of no kind that is known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an expression begins with [</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an external reference, whose file is not opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an incremental move needs a known position</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an input and output expander failed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an input and output expander was reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an input was active at start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an inverse-time feed needs a known position</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an offset came damaged: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an operation uses tool {number}, which neither the job nor {form_file} has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an operator is missing or unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an order names an item that is not there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an outline or island is open</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>and {corners} smaller ones</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>another connection is using the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>another task is open in the task panel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>another user listens there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>another user's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>approached from above, the axis stands below where it stands when approached from below</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs are in XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arcs outside the plane XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>arrange them again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for at most {fewer}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for at most {fewer}, or {narrower}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for the right to use it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for the way back again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>assign it before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least the kerf of {kerf_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {0} deg: a nose angle of {1} deg or less</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {chord:.4f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {depth_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {least:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {least_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {length_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {need_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {rough_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {z:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {z_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {0} deg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {0} deg: an entering angle of {1} deg or more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {largest_tool}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {longest:g} times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {most_mm:.2f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {narrowest_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at most {room_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at the profile's interval the letters are too fast for {axis}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at z {0} mm, radius {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at {z:.4g} mm along the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at {z:.4g} mm along the axis, radius {r:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>attach to it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>attach to that one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>attach to the session again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>automatic mode: from here on the link cannot stop the lathe, and only switching it off returns it to manual mode</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>axis offsets may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>axis words stand where no command uses them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>axis.{missing} is missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>axis.{without}.jerk_mm_s3 is missing: ramp = "s_curve" needs it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>back along the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>back edge at {0} deg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>back to where the program paused: up, over, down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash cannot be compensated in an arc with an absolute centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash cannot be compensated in rotated coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash cannot be compensated in the dialect {dialect}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash cannot be compensated within this line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash has three values, one for each axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>backlash_mm must be below the travel of the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bar_mm must be below smallest_bore_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>batch journal</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>before it starts set the Z zero with its tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin beside the sheet and enter at its edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin farther away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin it at the end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin lower or take smaller steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin operation:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin operation: {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin the comment with ;</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin the file with the line '# units: {other}', or say that unit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin the program with a rapid to a safe Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>begin with rapids that name X, Y and Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>below {depth_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>below {length_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>below {minor_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>below {narrowest_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>below {total_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>belt_pitch_mm and pulley_teeth belong together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>between curves {one} and {other} the kerf does not fit, at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>beyond a million nothing of the shape is left</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>beyond these a step lasts over a minute or no time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>blur the picture, scale it down, or choose another threshold</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bore_mm belongs to a stock of the form 'tube', and to no other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bore_mm must be below diameter_mm, {limit}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>boring takes a tool for the inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>both radii must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>break the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bring it back, or choose another file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bring it to Idle first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>build the zip for it: make installer PYTHONS={version}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bytes when it is unpacked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>canned cycles may not be used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>catch it, and stop the spindle after it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>chains have fewer lines and arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>chamfers and fillets lie between two lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change F in the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change one of its dimensions</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change the distance or the tolerance a little</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change the text to start it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change the tool at an M0 pause, or split the program at tool changes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change the tool, then resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change to tool {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>change_ms is so small that there are more than {most_waits} waits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>characters with its entities in their places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>charts are there for: {processes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check both switches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check both switches, then home again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and baud rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and power of the machine, then connect again: that starts the controller of {machine} anew</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and power, then move the tool to the work zero and set it there before its next move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and power; home the machine or set its zero again before the next cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable, grounding and baud rate, and that this program supports the firmware</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable, power and other programs on this port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check its cable and settings, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check its cable and supply, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check its supply and cable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check its supply and cable, then send again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check its supply and the reset button; home the machine or set its zero before the next cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check power, cable, port and baud rate of the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check that it is a grbl 1.1 controller and that the baud rate is right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the baud rate and what is connected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the baud rate, and which reports the controller sends unasked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the cable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the cable, and look that the controller is not in check mode ($C leaves it); then send again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the computer's clock, ask who runs the network for its certificate and set the environment variable PIP_CERT to that file, {zip}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the depth, or lay a spoil board under the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the probe's wiring and plate, then unlock with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the program again, and send it with the certificate that this gives</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the state of the machine now, then answer again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the switches, and max_travel_mm in its configuration</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check the switches, and travel $130 to $132</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check which curves are outlines and which are islands, and stock_to_leave_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>checksums are not part of this dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>chip_load_min_mm must not exceed chip_load_max_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose 'Install packages…' in the CNCStepper menu, or install them for Python {version_info}.{version_info2} into a folder of their own (pip install --target FOLDER) and name it in the environment variable CNCSTEPPER_PACKAGES</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose S from {min_rpm:g} to {max_rpm:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a body or a mesh of the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a folder that exists and that you may write to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a line that was cut after the last tool change and before this one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a machine with a Z axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch with circles or points, or give the places by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch, closed wires or faces for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch, edges, a solid of revolution or points for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch, wire, B-spline or freehand line for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch, wires or faces for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a smaller tool or less stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a smaller tool, or drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a solid, for example a box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a tool of at most {widest:.3f} mm diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a tool that reaches further, or cut this part with another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose an earlier line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose an earlier place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another file, or another machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another font, or other characters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another process in the job, or delete the operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another threshold, or invert it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose its job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of the job's tools for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of them, or cut them all with a pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of them, or join them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of: {choices}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose other values, or try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the job whose machine runs it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the job's material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the pass yourself: the program sends lines again, so line {line} alone is no place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the right machine profile, or correct the settings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the zip of 'make installer', or the folder in which its .whl files are</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>circles and points of several drawings that stand about the same centre, one hole each: {twice}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>clamp the tool with more stickout</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>clear the cause, then reset the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>clearance_mm must not be below retract_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close all FreeCAD windows, start FreeCAD, and install before anything else</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it and home again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it and resume, then go back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it first: cncstepper disconnect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it in the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it or set closed = false</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it with )</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it with &gt;</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it with ]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it, or leave only closed lines in the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it, or name another layer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it, or use side "left", "right" or "on"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it: draw a whole ellipse instead of an arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close other programs on this port and check the cable; then set the zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close the door, then resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close the other connection, a web page or a pendant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close the other program that holds it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close the safety door and resume, or reset it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close the safety door, then resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>closed belongs to points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cncstepper disconnect --port {port}, then connect again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>compute it in several lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>connect again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>connect to its port without a machine profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>connect to the internet and try again, {zip}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>constant surface speed became a speed a move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>constant_surface_speed takes surface_speed_m_min and max_rpm: take spindle_rpm out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>convert the text to paths in the drawing program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>coordinate systems may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>coordinates alone may not follow {motion_name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>copy it again and compare its size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>core_diameter_mm must not exceed diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>corner_a = [{0}, {1}], corner_b = [{2}, {3}]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>corner_radius_mm must not exceed half of diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct R or the end point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct R or {normal}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct centre or to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct it; paths are relative to the order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct its configuration file, then restart the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct its configuration, then restart it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct its spelling or take it out; known {table}are: {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that line of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that one first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that program, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the O-words of the macro</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the P word, or the board's settings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the centre or the end point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the comment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the diameters or pitch_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the drawing's unit, or take out what is drawn many times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the drawing's unit, or take out what is drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the entry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the expression</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the expression in that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the file's name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the file, or export it as STEP</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the folder's name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the homing settings ($22 to $27, $44 to $46)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the insert's code</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the jog command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the parameter in that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path or the file's permissions</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path, or the tool's shape and nose radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path, the lead-in or the kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path, the tool's diameter or the depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the program, and check it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the script</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the template's rules</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the value or its unit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the word before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct those that are, and check again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct work zero or program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct work zero or program, then unlock with $X; the position is kept</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>count is no whole number within its bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curve {number} has no length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curve {number} is closed, it has no {side}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curve {number} is open, it has no {side}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curve {number}, which begins at X{x:.3f} Y{y:.3f}, crosses itself or encloses nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curves do not meet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut always</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut both in one operation, which leaves the gap standing, or use a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut holes before the outline round them, or hold the piece by tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut in more levels, or take a longer tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut it before, or hold the piece by tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut it in one way, or with a machine whose language has M3 and M5</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut on the stock that the moves before it have left, and judged against the shapes of the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut some of the curves in an operation of their own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut the kerf test at that feed and add a row to kerf_by_feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut them together as a pocket, or this one with an operation of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut with a kerf of at most {most_mm:.3f} mm, or draw that place wider</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut with a kerf of at most {room_mm:.3f} mm, draw the hole wider than the kerf, or set spot_below_mm above {diameter_mm:.3f} to spot it for drilling</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut {depth:.3g} mm deep at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cuts {overlap_mm:.3g} mm before the place again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cx cy</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cx cy r</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>dask.distributed is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>define it, or put its file beside the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>describe it in a [[tool]] table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>diameters must rise, and each range lead from its least value above 0 to its most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>does not lie flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>dog-bones or a smaller tool remove it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw a circle, or cut it as an elliptical pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw an outline that encloses one area</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw at least two points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw circles or points where holes are wanted, or give the places by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw holes as circles, or give points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it in a [[shape]] table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it joined up</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it larger, or leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it on the XY plane or on one parallel to it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it on the XZ plane, with X as the radius and Z along the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw its half profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw lines, arcs, circles, polylines, ellipses or splines in its model space, on visible layers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw one rectangle, its corners rounded alike or not at all, or cut it as a pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw outlines with an area</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw polylines in place of single lines, or split it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw something in it, or choose another drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw them as points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw them {kerf_mm:g} mm apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw visible shapes, paths or texts; convert pictures to paths in the drawing program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drawing sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drawings with the suffix '{suffix}' cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drawings with the suffix '{suffix}' cannot be written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drill first, or turn a tube</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drill wider</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drill {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drive a laser by a controller with grbl's laser mode</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drop the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>edge_mm must not be below zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>elements within each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enable homing ($22=1) or switch soft limits off ($20=0)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end it at the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end it in .gif, or install ffmpeg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end it in .pdf or .html</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end it with #</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end other programs, or lower max_rate_mm_min in the machine's profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end that session as {user}, or remove the file as {user} where none runs any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the move at the axis, at most a nose radius beyond it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the name in .json</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the name in one of {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the profile at the X where the cycle begins, or make I larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the tool change and resume, or reset it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end the tool change, then resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ends were moved together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enter by a helix or ramp, or in the middle of a hole drilled before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enter the proxy in FreeCAD (Preferences &gt; Addon Manager) with its name and password, as http://name:password@host:port, {zip}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>entered here, the program would do something else than when it is run whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enters line {line} at {place}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enters there because {note}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>entities with its blocks taken apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>entry "plunge"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>error:{error} {meaning}; {advice}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>every line is cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>every line is cut, only the program's end was not seen</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>exclusively lock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>expand it first: cncstepper convert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>expand it into plain moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>export it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>export it again, as binary STL</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>export the solid as STEP again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>expressions in brackets are not part of this dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>facing takes a right-hand tool for the outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed mode set to inverse time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed mode set to units per minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed mode set to units per revolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed_min_mm_rev must not exceed feed_max_mm_rev</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feeds a turn became feeds a minute, at the speed that S asks for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feeds of inverse time became feeds a minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>find the cause, switch the lathe off and on, and set its zero by hand: its position is lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>find the cause, then home the machine: its position is lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>find the cause, then move the tool to the work zero and set it there: its position is lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish operation:</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish operation: {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab) is larger than the tool's radius allows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish_{name} leaves nothing to rough</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>fit the scaled curve anew</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flute_length_mm must not exceed length_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>formats inside MTEXT are not applied</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>free space on its disk, and resume when the journal is written again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>free the machine from the switch, then home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>free the probe, reset, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>free {size} MB</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>from 1 to {found}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>from 1 to {runs}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>from here on findings of this kind are not listed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>from z {0} mm by {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>from {begin} at line {first_line}, to {end} at line {last_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>front edge at {0} deg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>full circles became two arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>gap {gap_mm:.3g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>gap {gap_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>gaps were closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give --at once for each copy</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give --tls-ca, --tls-cert and --tls-key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give /dev/parport0, socket://host:port, a serial device, or record:FILE</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give 2 or 3 numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give F before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give G64 a P, or follow the exact path with G61</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give I, J and K from the start point of the arc (G91.1)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give X,Y,Z in mm, for example 100,70,20</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give ^ with G90</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a TOML file or one of: {profile_names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a device name or socket://host:port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a diameter above the bore and a length above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a file that ends in {endings}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a finite number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a greater height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a height_mm within the solid, or none for its whole outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a program that cuts along X and Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a smaller file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a start position of X, Y and Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a value that the setting allows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a way of 0.0001 mm or more and a feed above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give all of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give all points one Z and tilt the line by its Placement</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give an F word before the first feed move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give dwell_s, or use G81</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give each material its own number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give each outline a drawing or a layer of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give each row its own number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give either screw_pitch_mm, or belt_pitch_mm and pulley_teeth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give every line as many</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give every row as many</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give fewer copies, a smaller gap or a larger --sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give fewer points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give heights over the bottom, and the largest as the stock's Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give it another name, or change that one with: cncstepper machine set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give it another number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give it or its tool a feed_mm_rev</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its centre with I, J or K</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its diameter for X and for Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its {own_key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give parameters {first} to {first2} with the start state, or use G53</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give peck_mm, or use G81</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give spindle_rpm or surface_speed_m_min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the arc's centre with I and J</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the job another name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the material its number and name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the number of the run</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the path of a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the stock a greater face_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the stock and the tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the text to be replaced</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the timeline its machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool a length_offset_mm, or choose another tool_length for the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool a {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool its flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool its length_offset_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool table with the start state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool with the start state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the whole list or table, for example outputs.coolant=['mist']</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the work zero and the position, or choose a place after the next rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the work zero to have the travel checked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give them different homing passes ($44 to $46)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give two opposite corners of a rectangle, or three and more of a polygon in their order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give {key}, or a pattern of circles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>given up: the controller was reset or is locked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go back along the cut while a job is held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go back along the cut while a job runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go back with `cncstepper back`, and on with `cncstepper back --resume`</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go line by line while a job runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go on, or stop the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>go round the sheet, or cut with G1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes down at {plunge_mm_min:g} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes on with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>goes to Z {height_mm:.3f} first, straight up (it is not sent while the tool stands higher), then over the place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grbl follows the exact path always: leave the word out or write G61</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grbl has G54 to G59</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grbl has no canned cycles: write the holes as plain moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grbl moves X, Y and Z only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grblHAL takes arc centres from the start point only (G91.1)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grip with {force:.4g} N, or cut {depth:.3g} mm deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>grooves and parting take a blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>half a notch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>half of both diameters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>half of the kerf, {half_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>half the diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>half the difference of the diameters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>has no</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>heights belong to a stock of the form 'height_field', and to no other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>heights differ by {rise:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>hold it first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>hold it first: Ctrl-C at `cncstepper send`</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>hold or stop it where it was started, or wait until it has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>hole {0} of part {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>holes on the axis take a drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home all axes with $H</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home it, or set the zero of all axes; only jogging works until then</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine ($H), or unlock it ($X) if its position is surely right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine, or move it off the switch by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine, or unlock it if it stands where it should</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine, or unlock it with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>home the machine; or move the tool to the work zero, set the zero of all axes there, and send without moving it in between</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>homing can be stopped</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>homing found no limit switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>homing is not enabled</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>homing is set up wrongly</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>homing was interrupted by a reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>if it was cutting, the position is unknown: look at the machine, then see {session_file}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>in absolute mode the control drives an axis without a word to 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>in inverse time every {name} needs its own F above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>in the operation {span}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>incremental coordinates became absolute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>input: two inputs are on {twice}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install CNCStepper on every worker, and look at the worker's log</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install Python {version} (Debian and Ubuntu: sudo apt-get install python3-pip), or set the environment variable {variable} to the path of one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it (Debian and Ubuntu: sudo apt-get install python3-pip), {zip}, which brings a pip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it again, or choose another font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it for the Python that proves (python -m pip install NAME)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it: python -m pip install distributed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it: python -m pip install spyrrow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it: python -m pip install {package}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install the same version on all workers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install them in one (python -m pip install {packages}), or set {variable} to a Python that has them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>is read as a line of its own, in a whole program, where the dialect has subroutines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it appears when that is done</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it begins with {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it changes a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it closed the connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it contains a file that no bundle has: {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it cuts upwards on a helix, as thread mills do, and is entered at its begin, line {begin}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it does not begin with M</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it ended with an error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it ends at X {end_mm:.4g} Y {end_mm2:.4g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it ends too early</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it ends with {0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has a face that belongs to no solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has accepted nothing for {limit:g} s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has chains on {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has neither a stroke nor a fill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no boundary</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no face with an axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no face {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no glyph {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no outlines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no subroutines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no visible object with a face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no widths</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has no {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has them on {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has too many tables of pairs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has {styles}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has {ways}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has: {entries}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it holds more than a bundle does</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is a device</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is a folder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is cut short</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is empty</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is for {processes}: choose another chart or process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is no BREP file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is no STEP file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is one program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is too long for its tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is uncertain which of several passes was cut, so the earliest possible one is used: line {file_line}, not {file_line2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it is within a way into the cut, which begins at line {file_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it makes a folder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it makes a link</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it maps no characters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it names no operation: choose a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it opens a connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it removed its file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it removes a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it removes a folder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it renames a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it resumes without a person</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it should be *{summed}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it shows no solid: give one to show_object, or name it result</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it starts a process</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it starts a program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it takes more memory than it may</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it takes too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it uses '{address}', which is not in the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it uses itself, or too many others within each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it was a restart itself: the first line not certainly cut is the program's {story}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it was compressed or encrypted anew</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it was not placed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it would erase the settings: write the settings that you want to change one by one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it writes a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>item {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its begin is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its boundary is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its controller's process has ended ({status})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its directory is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its effect depends on the machine: leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its file '{name}' is neither here nor in ../Bit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its first element is no &lt;svg&gt;</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its head is no object of JSON</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its head is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its height is no length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its host is not this computer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its knots and points do not belong together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its knots do not rise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its letters lean too far</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its line map is no array of whole numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its lines are too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its machine position is not 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its messages do not fit their lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its number is above {largest_number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its numbers make no curve: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its operations are: {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its outline would cross itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its owner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its program has ended with M02</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its radius is not above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its shape '{kind}' is none of {shapes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its symbolic links form a circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its transform is damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its weights are not above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its width or height is not above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its {0} has {1} numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its {name} are no numbers in bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>its {name} is no number in bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog again if it is still wanted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog it down to that height where the way below is free, or restart with the height {here_mm:.1f} (--height), at which it moves over the place directly</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog less far</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog to a place with more room, or test a shorter length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog with `cncstepper jog`: it lets the controller give up its lines first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>join them into one outline, or move one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>keep half a kerf beside the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kept only if the controller stayed powered and was not reset in motion; a greeting, an alarm or a wrong position shows that it was: then {home}; {until_homed}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kerf = kerf used + (S - part + hole - S / 2) / 2</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kerf = kerf used + S - part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kerf_by_feed: feeds must rise from row to row, and kerfs must not</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kerf_mm is not what this tool cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind "turning" or "boring"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind = "boring"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind = "drill"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind = "parting"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind = "threading"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>kind = "turning", hand = "right"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>large cuts are being prepared, once after an installation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>larger than {largest_bytes} MB</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>laser mode needs a spindle of the kind Laser</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>laser mode needs a variable spindle output</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>laser mode: 1 is on, 0 off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>last seen</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lay the work in its axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lead in and out through scrap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lead times speed is more than axis {axis} can: {lead:.4g} mm at {rpm:.4g} rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leads had to be made smaller to stay in the scrap, down to {smallest:.0%} of their size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>least_ms must not be above first_ms</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave '{name}' out, if the machine's operator does it by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave blade_offset_mm out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave it out: Marlin has only this mode</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave less for the finishing pass, or islands remain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave one ellipse in it and draw the rest elsewhere or as construction lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave one ellipse in it, drawn as an ellipse and not as a B-spline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave part = "holes" out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave so much, ask for fewer tabs, or cut with a narrower kerf: no smaller pierce_mm does</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave that setting out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave the N words out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave the check mode with $C</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave the joints out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave the others out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave them out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave {key} out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leaves the spindle off, as the program has it there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out: G61.1, the machine may round the corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out: G64, the exact path is followed as far as the machine does</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out: the lengths of tools; set the Z zero with each tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out: {lacks}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>left out: {letter}, which never moves; that axis stands at 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lengthen the thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lengths of tools went into the coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>less than a kerf is left of a part between two cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>let Z always rise or always fall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>let it plunge at the start of the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>let it stick out {length:g} mm at most, or support its end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>let z never rise along it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the head higher, or go round the piece</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the tool before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the tool between them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the tool over it, move the clamp or move the shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>limit {limit}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line numbers begin at 0 or above and grow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {0} back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {0}: {1} of {2} not placed: {3}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {file_line} is run from its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {file_line} makes several moves and is run from its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {first_line} may not have been begun, line {last} may have been sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {first} to {file_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {own} here is its line {file_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {place} of the journal is damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {place} of the journal is not the one that was written there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lines of '{drawing}' that are not whole circles, so that no hole is drilled: {lines}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lines with / are {word}: no switch deletes them any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>load the module ppdev, and give your user access to the device</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>log in again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>log in as a user with that permission</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>log in first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at cable, shielding and grounding; the part may be cut where it should not be</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at its case, or look in comments too</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at its name and rights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at its switches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at motors and drivers, reset, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at motors and drivers, then reset the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at spindle and inverter, reset, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at spindle and inverter, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the Bluetooth settings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the controller's file system, then try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the details, and report them where they do not help</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the machine, and restart the program by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the memory card, then try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at the network of the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at this drawing alone: cncstepper job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look for a pendant or another program that is connected, set the zero again, then send again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look that the tool is off, and start the job again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look the number up in the documentation of the controller's version</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look whether the file is whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look which machine moves, and stop it there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower F, or turn the spindle faster</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower F; the machine will take longer than the feed says</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower ap_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower spindle_rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower steps/mm or maximum rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower taper_deg or its length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the feed here, or the axis' rate and acceleration in controller and profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the feed of that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the feed, or turn the spindle faster</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the stepover, enter by a helix, or leave less in the corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>machines with more than three axes are not written for Mach yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>machines with more than three axes are not written in this dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make D smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make Q larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make a profile by points and choose that</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make a profile of your own from it: cncstepper machine new NAME --from FILE</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make and prove it with `cncstepper run`</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make finish_{name} smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it shorter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it smaller, or islands remain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make its side longer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make one object of each layer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make resolution_mm larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make room (the packages take about 400 MB) and try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make room on the disk of {folder}, and see that you may write there; then send again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make room on the disk of {parent}, and see that you may write there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make several jobs of this one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make several texts of it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make spacing_mm larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make stepover_mm larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make sure that the axes are at rest, check cable and grounding, and home again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the corner radius smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the folder writable for yourself; nothing needs an administrator</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the job again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the lead-in longer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the leads or the tool smaller, move the parts apart, or do without leads</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the list shorter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the passes, the levels, the resolution or the entry angle larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the program again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the program smaller, split it, or use a larger machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the tabs narrower or the tool smaller, or cut without tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the text smaller, move its start, or lengthen the curve</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make them coincide, or keep them {small_mm:g} mm apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make them lower</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make {name} larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>making and proving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>margin {margin_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>marks_for names '{title}', which is no rule with a sheet_cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material is left on profile '{name}' where its tools reach</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material is left where it should be removed{islands}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material stays in {gaps} gap(s) between walls that are narrower than the tool, the deepest one before X{x:.3f} Y{y:.3f}; a smaller tool removes it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material that is cut off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material {number} has no {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>measure again, or correct steps_per_mm first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>measure again; where it is true, work steps_per_mm out with: cncstepper axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>measure the width of its cut, or leave kerf_mm out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mend one of them, or select others</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mend that object first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mend the file that it was read from, where that is not meant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mini-lathe B</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more of the {tool} tool's rim is in the material than it may</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than a million million</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than a million of anything is a slip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than ten times the whole is a slip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than {most} lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than {radius:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more than {way} steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>motion mode set to none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mount it first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move it {in_mm:.3f} mm inwards, or take a larger sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move one of the corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move other axes before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the holes apart, join them, or draw a slit yourself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the line away from the part, or leave it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the machine off it, then home</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the machine off the switch, reset, then home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the parts farther apart, enter from another edge, or use a thinner wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the parts farther apart, or cut them in several operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the shape inwards, or take a larger sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the shape or the work zero, or take larger stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the slider to start it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the tool to the work zero and set it there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the tool to the work zero and set it there before its next move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move the work zero {word} the {name} axis or make the program smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move them or the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move them {more_mm:.3f} mm farther apart, or cut with a kerf of at most {gap_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move there first with absolute coordinates, or give the start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move there with G90 first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>move {letter} on a line of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>must be {number} from {words}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name X and Y in a rapid above the stock first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a file that ends in .ttf, .otf, .ttc or .otc; unpack a web font first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a file that is not there yet, in a folder that you may write in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a line that was cut before this one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a new file, or one that pulses were recorded in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a parallel port (/dev/parport0), or a text file with the numbers of the pins that are high</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a parallel port, a serial device, socket://host:port, or record:FILE</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a profile with both</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a script with the suffix .py</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name a shape of one curve</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name an axis that it has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name another machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name both axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name it once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name its insert, or its angles and nose radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one of {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one of: {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one that the system has: {families}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name one, or save the document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name the machine (--machine)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name the machine profile of the table that is wired to it (controller = "thesis-a")</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name the material, or write a [[tool]]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>named parameters are not part of this dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nest them again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nested too deeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>next is line {line}: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nichrome 0.4 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no Python {version} is found outside FreeCAD to run pip with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no arc or wire stands at more than 10 kV</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no axis is set up for homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no axis lifts a tool by more than 10 m</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no axis pushes with more than 100 t</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no axis runs faster than 16 m/s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no axis speeds up by more than 100 g</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no closed curves at that distance were found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no code on this line uses the word {letter}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no conversion makes this a program for {dialect_named}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no cutter's edge runs faster than 170 m/s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no drive changes its acceleration faster</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no encoder counts more in a turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no encoder for '{file}' is installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no feed rate was set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no file system is mounted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no gear turns ten thousand times faster</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no identity of a port: {content}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no input may be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no jet is driven by more than 10 kbar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no job is held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no job runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no machine holds a tenth of a micron, and above 10 mm nothing is held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no material is stiffer than diamond</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no material needs more than 100 kN on a square millimetre of chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no memory card is mounted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no modes are kept here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no move of line {line} lies on the way back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no operation, or more than one, is called '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no output may be set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no parallel curve that far inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no part is chosen</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no pass is narrower than a micron or wider than 10 m</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no position may be stored</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no process has it any more: remove the file as {user}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no process, or no port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rapid leads to this way, and backwards it does not begin where the one before ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rapid of the program says at what height the tool may cross the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rates in the machine's profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no regular file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rule of the template takes a chain of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rule of the template takes chains of the drawing: {counts}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no rule takes {0} chains of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no scheduler answers: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no screw and rotor has more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no solid is chosen</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no spindle of a lathe or mill has more than 1 MW</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no spindle turns faster than a million a minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no spline is cut in inverse time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no spline may be cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no step is finer than a micron and no table longer than 100 m</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no stepper motor gives more than 10 kNm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no straight slit leads into the hole at X{x:.3f} Y{y:.3f} past the part's other holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no tab fits on any contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no table is longer than 100 m</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no token, or no path of a socket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no tool cuts thinner than a micron or deeper than 10 m</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no tooth takes more than 10 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no torch or wire draws more than 10 kA</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no way through the scrap leads to what lies at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no wheels in</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none of the selected drawings can be followed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nose radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nose radius {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nose {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a DXF file: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a FreeCAD document</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a JSON file: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a PNG or JPEG picture: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a TOML file: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a TrueType or OpenType font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a curve with xy and bulge: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a job to send: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a line of a material file: '{line}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a number: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a parameter of a material's comment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a point: '{line}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a status: a vector has other things in it than numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a status: its {name} is no {kind_name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a status: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a text file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a tool bit: it has no shape or no parameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a tool bit: its {key} is no object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a tool library: it has no list of tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a tool of a table: '{line}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not all of a parallel of the wall is seen from the middle of the room</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not all of the wall is seen from the middle of the room</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an STL file, or one that ends too early: it names {claimed} triangles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an SVG file: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an error: its words are none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an error: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an object of JSON</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an outcome: it has no end state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not an outcome: {fault}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not certain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not known on {platform}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not the numbers of a curve: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>notes must be a list</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing answers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing answers at {name}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing answers at {name}: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing has been cut yet, so there is no way back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing here waits for more than a day</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is certainly cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is cut before this place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is held any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is known that could be asked so</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is left to cut from this place on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing may be probed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing may follow {keyword}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing more is sent to the lathe: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves at line {number} or after it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves in the plane {plane}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves that could be held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing that a tool could follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing that an axis moves weighs more than 100 t</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>numbers 1 to {largest}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>numbers behind {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>o&lt;name&gt; sub ends with o&lt;name&gt; endsub</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>o&lt;name&gt; sub is called by o&lt;name&gt; call</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>objects or lists are nested too deeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>on its line a contour has no scrap side for leads</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>on its line a contour has no wall for dog-bones, a finishing pass or stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>on the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>one circle of the shape lies within another</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>one more client beside {known_limit}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>one of 8, 11, 14, 17, 23, 34, but it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>one of its points is no number in bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>one pass is {deepest_mm:g} mm deep, deeper than the tool's diameter of {diameter_mm:g} mm; give stepdown_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only X, Y and Z are edited, not {letter}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only a drag knife has a blade offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only a pin with a number has a port: the device file of its parallel port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only arcs of G17 can be turned about Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only the controller knows where a probe stops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only the first control point goes without X and Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only {free} kB are free</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only {written} of {data} bytes were accepted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>open chains</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>open line {line} cuts into a part at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation '{cycle}' uses tool {tool}, which the job does not have</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation must be a list of tables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation {number} ({cycle}) will take long: about {length_mm:.0f} m of cut in {levels} levels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation {number} has another {key} than its file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation {number} turns the profile '{profile}', which the job does not have: it has {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation {number} uses tool {tool}, which the job does not have: it has {tools}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>or press 'From files' and take the zip that 'make installer' has built on a computer with internet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>order table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>order text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>otherwise the move would be bent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>outlines and islands lie too close to each other to be told apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>overrides may not be switched</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>o{name} has no end: the text is over, and it is still being skipped</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parameter 5220 names no work system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parameters (#) are not part of this dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parentheses are no comment here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>part '{name}': {what}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>part of the drawn shape is beside the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>part {number} goes beyond the sheet at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parting blade {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>parting off takes a blade for the outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>peck_mm must not exceed depth_mm, {limit:g} mm; write 0 to drill in one go</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>peck_mm {peck_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pick edges only, or the whole object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pick it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pierce farther away from earlier cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pierce in scrap, and lead in to the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pin '{pin}' is no pin of a controller; there are {controller_pins}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pin {pin} is no input of a parallel port; inputs are 10, 11, 12, 13 and 15</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pin {pin} of {port}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pins.{name} is no signal; there are {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pins.{name}: pin {pin} is an input of the parallel port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pins.{name}: pin {pin} is no output; outputs are 1 to 9, 14, 16 and 17</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pins: two signals are on one pin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pip could not install the packages: {said}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pitch_mm is lowered to {pitch_mm:.3f} mm, for the helix must not fall by more than {most_deg:g}°</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place the copies elsewhere</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>place them farther apart, or --allow-overlap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>places of the machine became those of the work, right for this work zero only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>places where a chain crosses itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>places where closed chains cross each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>planes are an option of the build: leave it out, arcs are in XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>please report it, with the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>please report it, with the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>plug the controller in, or give one of the ports that are there: {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>points are not pairs of x and y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>points with its blocks taken apart ({splines})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>positions are not compared with the path any more: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prepare the program again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prepare this program's own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>press on one in the 3D view</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>press the machine's own switch, or let it run to its end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>press the machine's switch; no further line is sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>process must be a text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>profiles are turned towards the chuck with a right-hand insert</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>programs are not written in the dialect {dialect}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>programs are read for machines with three axes, or with nine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>programs of these names are there already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>programs of {language} are in one unit only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>programs with more than the axes X, Y and Z are not written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prove parts of the program alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prove them together: cncstepper run JOB</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulses are forgotten at rest only, not in state {state}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulses are those of a machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulses can be retracted only in a hold, not in state {state}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulses, relays and trials of a rate: `cncstepper machine-test` does them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put a text with commas in quotes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put in tool {tool:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put it before the way</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put it in brackets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put some in named parameters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>put the card in, then mount it with $FM</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radii and resolution must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radius 0 mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radius {0} mm at z {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise F, or turn the spindle slower</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise first_depth_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise interval_ms of the profile's signals</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise pulloff_mm in its configuration, or check the switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the R word of the drilling cycle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the feed, or turn the spindle slower</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the pull-off $27 or check the switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the tool first, or switch it off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ramp = "table" and planner.waits belong together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ramp {ramp_deg:g} deg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rapids and cuts would be exchanged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rapids move at the feed in force: no F for them was given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read as a flat mill: '{name}' does not name a shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read its message, and correct that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read its message, close other programs, or choose lower speeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read its output, and report it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read the controller's start-up messages ($SS) and correct its configuration</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read the message that the macro gives</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>read the program as a whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reading '{suffix}' files needs {programs}, which is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reading the solid takes too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reading the solid takes too much memory</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reading was cancelled</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>real time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>redraw it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>relay: {twice} is there twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>release buttons, door and emergency stop, then restart the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>release buttons, door, switches and emergency stop, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>release it, reset the controller, then home the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>release the emergency stop, then reset the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>release_line goes with line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reload it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>remove it as {user}; until then the position is unknown again at each connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>remove it; only plain ASCII without ? ! ~ may be sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>remove the lines with `%`</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rename one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>renumber by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>repair the mesh, and export it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>repair the solid, or use another thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>reset it, then home it or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resolution_mm is too coarse for the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart at another place, or send the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart at the begin of its operation, or send the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart earlier, or make a new part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart of {name} at line {file_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restart the program at a line before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>restarts are written for grbl, grblHAL, FluidNC, LinuxCNC and Mach: convert it, or run it whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume again, or set the zero so that the move to it is within the travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume again; if $341 is not 0, finish the controller's own tool change first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume or stop it where it was started, or with: cncstepper back --session {file}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume what it was doing, or reset it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume when it is at standstill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume, and hold at a later move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume, and hold once the machine moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume, so that the change is over, and hold it again then</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>retract along X beside the tailstock, or move it away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>retract before it, or make it a feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>retract mode set to old_z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>retract mode set to r_plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>retracted along the cut: go further back, forward, or resume from here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>route it around the part, through scrap</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rows must be a list of tables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>run this job with cncstepper run</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>rx ry</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it again as PNG</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it again from the drawing program as plain SVG</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as CSV</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as CSV in UTF-8</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as DXF again, as R2000 or newer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as UTF-8</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it as one of {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save it with styles as attributes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>save the file as UTF-8 text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>scale all axes alike</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>scale all axes alike, or write feeds a minute (G94)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>scale it down: 10 pixels a mm are enough for any cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>scripts that are written from the right are not set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see its log, and the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see its log, report it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see that it is a folder, that it is yours, and that you may write there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see that the dial counts in the axis' sense, and measure again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see whether it is whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>select a sketch, wires, faces or edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>select drawings or sketches and add them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>select the plane with G17, G18, G19</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>select those of its faces or edges that count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send the file again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send the program without O-words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send the wanted words by hand or reset the controller, look at the work zero, and send again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send them to a machine whose pulses this computer makes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set $0 to 2 or more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set $0 to 3 or more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set $22=1 if the machine has limit switches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set $32=0 or use a build with PWM</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set F by the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set Z by the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set a lead_in, or pierce_mm to half of the kerf, {half_mm:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set again at the pause at line {line}: {places} (machine, mm); later lines use this zero, earlier ones the old one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set backlash_mm to 0 in the machine profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set corner_dwell_s to at most {stand_s:g}, or cut more slowly</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set entry_slit = true, which cuts a slit through the part into each hole, or leave the holes out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set it again, and do not start before it is right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set it with M61 Q and the tool's number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set margin_mm to at most {margin_mm:.3g}, or move the parts apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set pierce_mm to that limit, or leave {scrap}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set process to "plasma", "oxyfuel", "laser", "waterjet", "drag-knife" or "scribe"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set ramp_deg and no tabs, or use a mill that cuts over its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the machine's settings again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the machine's settings again, then home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the zero by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the zero on the stock, then confirm it (--zero-confirmed)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the zero there, or check the program again with the zero that is set (--work-zero)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the zero with G10 L2 instead</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set them by hand, then try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set them farther apart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set up a program of that name on the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set width_mm to at most {width_mm:.2f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set {cadquery} to a Python that has CadQuery, or {freecad} to FreeCAD's command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sets G92 as it was: {array}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>several turns of an arc became one arc a turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shape '{name}' goes without the {entity_kind} {handle} of its drawing: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shape '{name}' goes without {skipped} more things of its drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shape '{name}': no shape takes the chains of its drawing at the nesting level {missed}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shape '{name}': two ends lie {size_mm:.3g} mm apart at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sheet refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sheet {number}: {small} pieces below 1 mm2 left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>sheet_cut does not cut by {process}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>short slice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shorten or split that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shorten that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shorten the start-up line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>shorten the travel along Z, or let the bar stick out further</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>simplify it, or divide it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>simplify the solid, or end the script's loop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>simulated on the stock that the earlier moves have left; the wanted shape is unknown and was not compared</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>slice it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>smooth_mm belongs to points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>soft limits need homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>solids of the file overlap at sheet {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>something else than grbl answers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spacing_mm asks for more than {most_tabs} tabs on one contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle stop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle, coolant or tool would be another</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle, torch or beam is on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle, torch or beam may still be on: look, and switch them off at the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle_rpm = {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spindle_rpm = {0}, for example</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>splines lie in the plane XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split it into several drawings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split it, or send it with cncstepper send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split that line in two</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split the order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>split the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>spyrrow is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>square, circle and squareness need the axes X and Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start it with cncstepper send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start it, or correct the URL</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start it, or write socket://host:port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start nearer to the part, then unlock with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start one: dask scheduler --host 127.0.0.1, and dask worker for each core</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start scheduler and workers with TLS keys, and give tls:// with --tls-ca, --tls-cert and --tls-key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start the spindle with M3 and S before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start the torch with M3 $0 S1, the scribe with M3 $1 S1, a spot with M3 $2 S1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>starts the spindle at {spindle_rpm:g} rpm, {sense}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stepover_mm (ae)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stepover_mm asks for more than {most_passes} passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stepover_mm asks for more than {most_passes} turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stepover_mm is too small for the engagement to be bounded by it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>steps_per_mm is {steps_per_mm:g}, but the drive gives {pulses_per_mm:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop it, then home it, or set the zero of all axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop the job: steps may be lost, or the machine was moved by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop the machine with its own buttons if it must stop now</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop the program, then jog</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop with M5 and M0 before the new tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stopped as asked after {acknowledged} lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stopped before the first line was sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stretches drawn twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stretches drawn twice were taken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>subroutines and loops were written out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>subroutines call each other too deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it off and on again; if it stays, look at its wiring</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it off first: M5</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it off with M5 before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it off with M5 sooner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it on with M3 and S before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it on with M3 beside the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the lathe off and on, connect again and set its zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the lathe off and on, connect again and set its zero; unlock an alarm with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the lathe off and on, set its zero by hand, and send the whole program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the lathe on in manual mode before it moves; its position is reckoned, nothing reports it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the machine off, or unlock and home it afterwards at the machine itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch the spindle on before that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switches the beam on at S{spindle_rpm:g} once it is down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switches the coolant on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>table_ms may hold no wait that is longer than the one before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tables or lists are nested too deeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tabs need either count or spacing_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take a larger stock, a smaller margin or placement = "box"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take a larger tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take a larger tolerance, or draw lines or arcs in their place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take a larger tolerance_mm, or draw polylines or arcs in their place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take a thickness within it, another consumable, or give a chart of your own with this row</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take constant_surface_speed out, and give a fixed speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out of the name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out of the parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out or add its code</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take it out, or use one of: NAME, {keys}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take more passes of a lower depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take one of them out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take one out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take one out, or give them different consumables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out inside = true</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out the G4, or switch the power off with M5 before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out the axis and the line at the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out the inner (</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out what is not turned (keyways, flats, cross holes), or draw its half profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out work_offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out {word}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take text out of it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take the kerf from the chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take the line out; the arranged program lies in one work offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take the others out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take up to 60 letters of a to z, digits, - and _, a letter or digit first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tapping became plain moves: the feed may be overridden, and nothing keeps it to the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tcp:// of this computer, or tls://</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>teeth and bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>test a torch, a laser, a jet or a wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>test its axes one by one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>test with the square, which changes none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>that of the inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the $ command is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the N word must be the first of its line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the NAME of material {number} names no material and thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the NEMA size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the O-word cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the O-word is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the P word is larger than the controller allows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the Python that belongs to this FreeCAD has no pip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the USB board's controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the actions between the moves would change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the angle is not known at the zero of the work system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the angle of the arc is so small that the controller would run a whole circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc begins at a place that is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc has neither I nor K nor R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc has neither {centre} nor {centre2} nor R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc has no axis word of its plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc has no radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc in the concave corner cannot be reached by the tool without gouging</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc lacks its centre offset in the plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc needs {axis} or {axis2} in plane {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc of a text needs a sweep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc would go through another angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc's centre is not as far from both its ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc's end does not lie on its circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc's radius does not fit its end point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc's radius is not larger than the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc's radius is too small for its ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arranged program has {count} cuts, not {wanted}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arrangement has no job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the auxiliary port does not exist or is in use</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the axes are X (radial) and Z (axial)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the back edge of the insert does not reach the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bar bends away from the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bar is slender: it bends and chatters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bar may turn in the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bar sticks out of the chuck too far for its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bars' width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the base's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the beam is never on during a cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the blade does not reach so deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the blade is wider than the groove</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the bore leaves the tool no room for a helix</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the buttons are not heard any more, so the machine is held: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the canned cycle is begun anew, at line {file_line}: G91 is in force</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate has an entry that no proof has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate is of another version</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate lacks an entry that a sender needs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate was changed after it was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate's findings are damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the changed line would lead elsewhere than it must</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the changed program makes other moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the changed program would make other moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the character {found} would act as a command of its own or is not ASCII</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart has no consumable '{consumable}' for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart has no kerf of {material} at this feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart has no row of {process}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart has too many rows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart of {process} does not cover this thickness of {material}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the chart of {process} has no material '{material}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the checksum is wrong</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the circle's share of it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cluster gave no result: {kind}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the columns of MTEXT are set one below the other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the command is allowed only while the machine is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the command lacks its axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the comment is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the comment of a material lacks nu= or na=</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the comment of a material lacks {key}=</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the compensated arc would have two radii</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the compensated tool cannot reach this corner without gouging</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the computer was late with a pulse and stopped after {written} writes, {at_ns:.3f} s from the begin; spindle, beam and drives are off, and steps may be lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the configuration is not valid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the connection service does not start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the connection {session_file} is open, but its process does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the console does not pass on {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the contour goes through the stock and sets a piece free that no tab holds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller accepts no jog while it is held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller asks for a login</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller did not store the zero of {axis} in {system}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not accept the password</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not allow this to this user</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not answer any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not come back from its reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not have this work system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not know this command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report ${number}: it was not compared</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report its modes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report its state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report its work system: {modes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report its {system}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report whether it uses mm or inches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller has just started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller has no memory left for O-words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller has not kept its position through the reset at standstill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller is idle but has not answered '{text}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller is locked by an alarm or a jog</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller is locked: home the machine, or unlock it if its position is surely right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller is starting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller of this machine has been started; it counts from the present position</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller of {machine} ended at its start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller raised an alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller reads its lines without moving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused '{sent}' (error:{error})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused '{sent}': {meaning} (error:{error})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused {line}: {meaning} (error:{error})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller reported: {report}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller reports that it is homed, but too soon: another line than $H reached it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted in the middle of the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened, so the machine's position is unknown: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from its present position</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from its present position. Until it is unplugged no later opening restarts it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller sleeps and its motors are off: unlock it, then home it or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller still waits for its new tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller stopped by a critical fault</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller waits for its new tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller was reset before it could do that</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller was reset while moving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller's configuration is not valid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller's own test at power-up failed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller's permanent memory failed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the converted program would continue after this</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the converted program would not pass this point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the coordinate system in force may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the corner is too large for its lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the corners of a clamp enclose nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the corners of a rectangle's diagonal must differ in x and in y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the count of copies is out of bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the crest of the thread lies below its floor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curve has no length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curve is not smooth here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curve is open, a closed one is needed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curve that {kind} follows is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curves of the drawing are too many and too wild for the tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut begins without its pierce delay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut begins without waiting for the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut goes into the part of another contour at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut goes into {hurt} outline(s) that other contours leave standing, most at X{x:.3f} Y{y:.3f}, by {radius_mm:.3f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut height is not the cut chart's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut is too close to the sheet's edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut leads through the edge of a part that a contour leaves standing, {where}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut needs more power than the motor has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut of the {tool} is deeper than it may be</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cutting force of {title} in turning is not in the table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cycle '{cycle}' takes no shapes of a drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cycle takes too many passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cycle uses a kerf of {kerf_mm:g} mm, the simulation the tool's diameter of {diameter_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the degree of the spline is out of bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the depth goes below the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the depth of cut is above the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the depth over the key</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk cannot be started: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk failed by a fault of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk of {port} is not there, or was killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the device has accepted nothing for {limit:g} s; steps may be lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the diameter of its middle line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the diameter of the points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the diameter of the tool is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the digits of {dialect} cannot hold this feed: F would be {written_mm_min:.4g} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the dimensions of the shape '{kind}' do not go together: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the disc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the disk is full</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the document unpacks to too much</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{deleted_drawing}' that it followed was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds an ellipse and no circle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds more than one ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no circles and no points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{drawing}' holds no single rectangle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{label}' does not lie flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{label}' holds a line that is no ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing declares XML entities that are longer than a short text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has no closed outline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has no curves on a layer '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has outlines beside each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has too many elements with those that it uses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has too many rules of style</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has too many {of_what}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing has too much text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing holds no curves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing reaches beyond the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing would become too many objects</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing {file} has no chains for the shape '{name}': {words}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing {file}: {words}: {count}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing {form_file} is damaged, a part of it may be missing: {damage}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing's unit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawings lie at heights from Z{least_heights:.4g} to Z{most_heights:.4g} mm; all depths count from the top of the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drill does not reach so deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ears</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the edited program has no job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the elements picked of '{drawing}' no longer exist</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ellipse in '{drawing}' is open</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the emergency stop is active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the emergency stop was pressed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ends of the legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the entry arc of the compensation is not larger than the tool's radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the entry move of the compensation is not longer than the tool's radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression divides by 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression divides by zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression has an operation that is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression is nested too deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the expression's result is not a finite number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the face lies before the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the factor must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed asks more of {name} than its highest rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed does not follow the spindle: choose a machine whose controller has G33</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed does not follow the spindle: write thread passes as G01 at F = pitch * rpm / 60, for a lathe that begins each run of G01 at the encoder's index (mini-lathe:thread_start=index)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed is higher than the machine's axes can go</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed is not the cut chart's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed per revolution is above the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed per revolution is below the tool's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed would be another</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed would round to 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be created</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be read: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file cannot be renamed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file could not be handed out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file could not be loaded</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file does not exist</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file gives no size in mm or inches: {dpi:g} pixels an inch are assumed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file gives no size of its sheet: zero is the upper left corner</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file has no pulse letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file has too many materials</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file has too many pulses to be shown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file holds no object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file is read-only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file needs a strip_height above 0 and a list of items</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file of the drawing has changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file of the drawing is not there any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file system can only be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file system cannot be formatted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file system cannot be mounted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file system could not be formatted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file system is busy</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the file was changed while it was read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the first line of an order names its columns: drawing and template, and material, thickness_mm, count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the first {0} are drawn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the flanges' width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the floor of the groove lies outside the material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the floor of the thread crosses the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder belongs to another user</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder cannot be deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder cannot be opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder does not exist</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder for packages cannot be written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder is a link</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder of sessions cannot be used: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the folder or zip has no {packages} for Python {version} on {system}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the font '{family}' has no style '{style}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the font '{font}' is not here; its text is set in {other}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the font '{font}' lacks characters of the text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the font '{font}' lacks {names}; they are left out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the font is damaged: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the fonts of {count} texts lack letters, which are left out: {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the front edge of the insert does not reach a flat face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the front edge of the insert does not reach the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the grid has too many holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the head goes over a piece that is free and may stand up</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the head's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the head's width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the heights cannot be read: {reason}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the heights do not fit their box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the highest spindle speed, which every S is scaled by</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the holder of the tool touches the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the holder of the {tool} tool goes into stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the hole for the head</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the hole is too narrow for the boring bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the inner one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the insert '{code}' has no {name} of ISO 1832</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the insert must fill 1 to 179 degrees from back_deg to front_deg: it fills {angle:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has a program for each of {count} tools, one after the other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has ended: {outcome}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has no operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has no operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has {of_what}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job is about to resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job is too long for a file that people read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job names no material, so the chart gives no tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job of {process} names no material and has no tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job still runs, on {port}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job was sent without a machine profile, so no way back can be checked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job's machine profile cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job's own program has changed since this one was edited</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jog came too late to be safe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jog command lacks its `=` or holds a forbidden word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jog ends outside the machine's travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jog was cancelled</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jog was stopped: its button was not heard of for {lapse_s:g} s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jogs before this one are not done yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal cannot be written ({trouble}): the job goes on to {place} and is held there; make room on the disk of {folder}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal could not be closed ({error}): the job will be listed as killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal is written again: a job that was held for it can be resumed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal lacks its beginning, or is none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal of the job cannot be written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the journal of the job cannot be written: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf closes a narrow place in the outline of part {number}, which begins at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf goes beyond the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf goes beyond the drawing into a part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf is wider than a place in the hole of part {number} that begins at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf is wider than hole {number} at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf of {kerf_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kerf test is too small for its kerf and leads</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the kernels were not compiled in advance: {said}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the key {name} is missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the key's width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the knots and poles of a spline of the solid do not belong together</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the largest disc of the {tool} tool stands more than a pitch above its tip: it cuts no thread</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the last line has no end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe cannot be stopped over its link: it runs on for {0} s, to X{1} Z{2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe finishes a move that it has begun: switch it off, then set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe is in automatic mode and cannot be jogged: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe is in automatic mode, or locked by an alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe jogs at up to {0} mm/min, or at {1}: it takes the slower one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lathe's timer makes a lead of {lead:.4f} mm, not {wanted:.4f} mm: over the thread {off:.3f} mm; at {rpm:.2f} rpm it is right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the layer of a profile must hold one chain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lead of '{text}' is no whole number of pitches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the leads fit nowhere in the scrap; the closest obstacle is {name} at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the legs' width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the length of the tool before is in force after the change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the length offset of tool {tool_number} is unknown; 0 is assumed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the length offset of tool {tool} is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the letters go farther than {axis} can travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the letters move {axis}, which this machine does not have</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the letters of the text have no {part}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the library has no shape '{kind}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the library has too many tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line before is not done yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line does not end where it began</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line does not fit into the controller's buffer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line does not fit the buffer of {language}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line ended too early</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line has no length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line holds a real-time command byte</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line in the concave corner cannot be reached by the tool without gouging</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line is longer than {firmware} can read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line is too long for the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line jumps to a line number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line map does not fit the lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line number is not between 0 and 9999999</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line number is out of range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line reads the machine's position, which the edit would change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines after it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines after this tool change cannot run on their own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines are being fitted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines have different numbers of heights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines of a retract are not at the controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines that would be sent mean another path than the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines to send are not those that were proven</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the lines to send were made from another program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the link to {name} broke: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the locks of the order contradict each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine can do no better with this tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine does not end its homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine does not home: {meaning} (error:{error})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine finds its own zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has no axes X and Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has no such spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has no work offsets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has no {name} coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has one spindle, number 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is at rest, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is homed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not at rest</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not at standstill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not at the begin of the retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not in alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not on the path of the lines that it has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not on the program's path: a line was damaged on its way</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is not where the program paused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine is still slowing down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine jogs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine jogs only while it is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine left the program's path: a line was damaged on its way, or the controller restarted unheard</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine must be homed before it may move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine must be homed first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine was stopped at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's buttons lead nothing back any more: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's controller does not have it: take it out, or cut the program in two there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's position is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the measured length is far from the commanded one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the memory card cannot be mounted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the mill does not cut over its centre: it can neither plunge nor come down beside a tab</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the mini-lathe's controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the minor diameter does not fit the major one and the pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the motor of {name} may lose steps: at {speed:.4g} mm/s ({rpm_at:.0f} rpm) and {acceleration:.4g} mm/s² it has too little torque</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the mouth's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the move after the end of a compensation must be a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the move leaves the travel of {name} by {over:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the moves before the restart cut into the wanted part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the moves before the restart leave material that should be removed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the name is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the name of a parameter holds a comment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the nose is too large for a hollow of the profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the nose leaves a fillet of {nose:g} mm in {count:g} inner corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the number of a subprogram</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the number of turns is a whole number from 1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the numbers of an arc are damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the numbers of {0} are damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the object of this program is no longer there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the operation has no feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the operation is too long for one program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the order has no rows, or too many</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the order is no CSV: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the order is no UTF-8 text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the other end has closed it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the outer diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the outlines are beside the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the outlines enclose nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the outlines, less islands and stock to leave, leave nothing to cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the overcut is longer than the contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the overlap is only {here_mm:.3g} mm: the cut begins there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the overrides differ from those before the reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the package index cannot be reached</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the packing of a strip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the parallel port's controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the parameters of the file are not in the order of their numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the part at X{x:.3f} Y{y:.3f} would come loose before it is cut, in any order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the part has no bore that opens at its front end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the part may differ from it by as much: lower P, or follow the exact path with G61</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the path begins at the machine's position: it has incremental moves (G91) only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the path contains the tool's radius and is right for this tool only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the path is entered above the height that is given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the path mode may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pattern cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the picture has no dark areas</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the picture has no size: {dpi:g} dpi are assumed; give its width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the picture has too many contours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the picture has too many pixels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the piece that is cut came free at line {line}: it has fallen or moved</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce delay is not the chart's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce height is not the cut chart's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce heights make no sense in {units}: the file seems to be in {other}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce is nearer to a part than the chart's lead-in is long: its spatter reaches the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce lies on a part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pierce lies on an edge that is cut already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pins of the machine are not known to this reader</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pitch of '{designation}' is too coarse for its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the place cannot be written: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the place of a restart is a line, an operation, a contour or a point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the plane may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pocket is so narrow that its way at this engagement would be too long beside parallels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pocket is too narrow for a {entry}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pocket is too narrow for its engagement to be bounded</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the points of a freehand line lie at different heights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the port is opened 8N1: neither a socket nor a pseudo-terminal has parity (the lathe itself wants 8E1)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the port {name} is lost: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the position along {axis} is not known here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the position along {name} is not known here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the position stored for {code} is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the power is on at the pierce for much longer than the chart's delay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe is at its target already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe touched nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe touched something where nothing was to be touched</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe was not in its start state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process of this task ended each time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that calculates the retract has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that cuts ended before it had an answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that plays the pulses has ended; steps may be lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that plays the pulses was stopped or got no processor time; all outputs are off, and steps may be lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that proves the program ended without an answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that reads drawings has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that reads the last job has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that reads the program has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile begins behind the stock's end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile cannot be reached from where the cycle begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile crosses itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile goes over the centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile has an undercut: it runs back towards the end face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile has no end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile has no key {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile is closed: it has no end at the chuck</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile is smaller than its allowance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the profile turns back along Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program begins at X{x:g} Y{y:g}, which is over the sheet: move the wire out of the sheet, to X{begin_x:.3f} Y{begin_y:.3f}, before it is started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program begins with the tool at the work zero: bring it there before this one is sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cannot be written: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cannot run from here on its own: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program changes no tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cuts along no way at one height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cuts nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cuts nothing at a known place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program does not contain the values of the material that QtPlasmaC has selected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has no F word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has no end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has no line to send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has too many labels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has too many lines for these numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has too many parameters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has {place}, which goes by the machine's own zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program holds no feed that is seen from above</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is larger than the travel of {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is none of the job's parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is not the one that was proven: its text differs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is read as {dialect}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is too long for it to be known which pieces fall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program moves nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program needs more than one tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program of a lathe cannot be restarted in its middle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program pauses while the spindle turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program pauses with the power on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program runs on and on: is there a loop without an end?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program sets its own work zero (G10)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program that reads the solid ended without an answer (status {status})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program waits with the power on in the middle of a cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven for another machine, or its profile was changed since</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven for another process, material, thickness or consumable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven from another start state: work zero, offsets or tool lengths differ</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven with another stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven with other clamps, or another distance from the sheet's edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven with other tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was read as {dialect}, which no controller understands that lines are sent to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was read as {dialect}: to {firmware} its lines may mean other moves, or nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program's file cannot be read any more: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the proof failed by a fault of its own: {kind}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the proof found {errors} error(s) in the program, the first: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the proxy of this network does not let pip through</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pulses have ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pulses were stopped: no more of them came in time; everything is off, and steps may be lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the radius at the end of the arc is {at_end:.4f} mm and at its start {radius:.4f} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the radius is too small to reach the end of the arc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rapid that leads to a contour must lead to another place, and cannot be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the reading</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the reading of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the reading of the last job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the record does not end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the replacement cannot be made: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the resolution is too fine for the ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the restart goes straight down first, from Z {high}, where the machine has homed, to Z {low}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract along the cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract cannot be read back: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract cannot be sent as it was written</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract does not lead to that place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract mode may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the retract plane lies below the bottom of the hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rim of the {tool} tool is slow for the material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rim of the {tool} tool is too fast for the material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the room falls into parts away from its wall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the room of the tool's centre has islands or several parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rotations of {name} are no list of 1 to 360</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the row has more values than there are columns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the row leads to an unknown place along {axis}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the row names no {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rows of heights differ in length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rule '{name}' clears areas, but takes open chains of the drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rule gives the shapes: leave {named} out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the safety door is open</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the safety door is open or the machine is parking ({status}): resume later</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the safety door was opened</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the safety door was opened while homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the scribe is tool {number} of LinuxCNC's table, whose X and Y are its place beside the torch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the second limit switch of a double axis was not found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the second limit switch of a self-squaring axis was not found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the section of sheet {number} is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the secure connection to the package index was refused, as in a network that looks into it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender failed by a fault of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender or its computer stopped suddenly; the controller may have executed the lines in its buffer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender's process does not start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender's process ended at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session refused {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session still runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session {session_file} has ended, and its outcome cannot be read: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session {session_file} is not there, or was killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session {session_file} runs, but its process does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session's log</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the setting cannot have this value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the setting could not be stored</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the setting's value is out of its range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the settings file of the machine is not known to this reader</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shaft's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shank of the {tool} tool rubs along the wall over its flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shape '{kind}' has no dimension {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shape '{name}' needs one of {ways}; {told}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shift of G92 went into the coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shorter side</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the simulation's process has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the slot's width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid cannot be read: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid has nothing at that height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid has too many edges or triangles</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid has too many edges there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid is not closed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the solid or a value has changed since the sheets were made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle cannot turn at this speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle does not follow the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle does not reach its speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle does not turn so fast</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle does not turn, but the motion goes by its turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle is switched on at S0, since no S came before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle of this machine does not follow X: it has no G96</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle runs while the tool is changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle speed is out of the spindle's range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle's speed is set by hand</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the splines and ellipses of the drawing are too many and too wild for the tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stack has more than {0} sheets; use thicker ones</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stack has too many sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stand-alone interpreter moves X Y Z A B C only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the start is in the stock: its z must be at least {face:g} mm, or its x outside {diameter:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the state of the machine's position cannot be stored: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the state of the stored settings cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the step of the notches, in degrees,</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the step pulse is shorter than 2 microseconds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the step pulse is shorter than 3 microseconds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the step pulse is too short</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stock needs three lengths above zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stored line is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the stored settings could not be read and were reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the subroutine o&lt;{call}&gt; has no end</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the system has no font</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the table gives it no diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the table has too many tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the table of tables is damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the table {0} lies beyond the end of the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tabs are as high as the contour is deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the target lies outside of the machine's travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the test leaves the travel of the axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the text</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the text has no letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the text is longer than the curve from its place on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the text is not found, or is the same already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the text is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the thickness of material {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the thread '{text}' is not in the table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the thread is longer than its cylinder of {diameter:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the thread is not longer than its pull-out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the thread takes too many passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the timeline</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tolerance is negative</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tolerance is too small for this curve</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tolerance must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tolerance must not be negative</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool ${tool} still runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool changer does not know which tool it holds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool cuts into the wanted part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool does not go into the drilled hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool does not reach into {corners} corners or narrow places; material left there: {told}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool fits nowhere along curve {number}, which begins at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool goes below the stock and cuts the table under it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool goes up or down while it cuts: backwards it would enter at the full depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is at Z {high}, and the restart first goes straight down to Z {low} as a rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is below the stock's top while its place in X or Y is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is changed by hand: write one program a tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is compensated already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is compensated in the planes XY and ZX only</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is down while it is changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is not at the work zero, where a program begins: jog it there, or set the zero here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is wider than the pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool number is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool number is too large, or the tool table has no such tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool offset may not be changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool runs into the {obstacle}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool table cannot be read again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool's position is unknown here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool's radius is compensated along this way (G41, G42)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool's radius is compensated: it begins at line {file_line}, with G41 or G42</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool's width is not the cut chart's kerf</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool's {letter} is unknown here, and a rotation needs both coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the torch cannot be switched off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the triangles of the STL file are not whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the turn of the work system went into the coordinates</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the value is no finite number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the value must be a whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the value of #{number} is known only when the program runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the velocity may not be reduced</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the virtual grbl ended at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the waits lie from {shortest_ms:g} to {longest_ms:g} ms, beyond {least_ms:g} to {most_ms:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wall may be up to {promise_mm:.3f} mm off: an ellipse is no offset of an ellipse, and the resolution adds to it; method "tolerance" keeps to tolerance_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the web's</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the web's thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the width across the flats</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire begins to cut inside the sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire goes through a part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire goes through the sheet without power</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire has no entry into the closed hole at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire is too thick for {corners} inner corner(s) or narrow place(s); up to {thick_mm:.3f} mm stays, most at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire moves before it is hot</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wire would stay too long at corners and melt a hole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the word {letter} has no number that can be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the words of {codes} are not edited</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work system is locked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work systems G59.1 to G59.3 do not exist here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero cannot be set here: the cut behind used another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero changed while the program ran, and not by the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero is not confirmed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero is not known, so the program's place on the table is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero was set at a pause, so that the retract along the cut is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the worker has CNCStepper {version}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the zero of the lathe can be set in manual mode only: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the zip is damaged or not whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool_shape} tool's form is not given, so it is judged as a flat one of its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} takes too thick a chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} tool cuts deeper than its flutes are long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} tool does not cut over its centre: it must not go straight down into full material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} tool has no number of flutes; its feed is calculated with {usual_flutes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} tool is too small against its path for its engagement to be measured</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {tool} tool rubs: a tooth takes too thin a chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>their distance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>then runs {own} lines of the program unchanged; everything before them counts as cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are A to Z for pulses and {0} for devices</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are no packages in the folder or zip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are no parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are no relays</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are {count} lines, none at {index}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are: {axes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are: {keys}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there are: {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is a machine profile '{name}' already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no act '{act}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no command '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no contour {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no cycle '{cycle}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no cycle '{told}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no dialect '{base}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no drawing '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no file for the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no folder for the drawings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no font '{family}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no function {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no hole into which the boring bar gets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no key {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no machine profile '{name_or_path}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no material '{material}'; use one of: {material_names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no material '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no motion that the coordinates could belong to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no outline and no stock to face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no override {kind} {step}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no parameter #{number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no part to draw</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no port {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no process '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no program to arrange</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no relay {0}; there are {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no room for a helix or ramp, and the tool does not cut over its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no room for a {entry} at {others} of {kinds} places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no room for the pulses' memory: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no scrap for the pierce and lead-in of {chain} near X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no scrap for the pierce behind a tab of {chain} near X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no single-line font '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no subroutine o&lt;{seeking}&gt;</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no such file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no such font file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no such part of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no such verb</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no {name} of that name</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no {packages} for Python {version} on {system}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is nothing to find</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is nothing to resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is nothing to resume: the machine is not held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is nothing to stop</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is nothing to unlock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there was nothing to read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>these diagonals belong to no rectangle of these sides</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this answer belongs to an earlier pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this build of the controller has no such setting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this client is detached</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this comment would run Python on the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this computer cannot keep the pulse rate of this program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this computer cannot keep the rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this computer cannot keep the rate of the program's pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this computer may fall asleep while the machine cuts ({why}): switch its sleep off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is a fault of this program: report it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no Python script</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no address of a scheduler</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no certificate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no input of a machine: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no pulse letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no word that can be edited</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is not allowed while an emergency stop or a limit is active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is switched off in the controller's configuration</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is the job of a lathe, not of a table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is {kind}, not a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this language is in millimetres</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this lathe moves in straight lines: write the arc as lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this line is executed in modes that differ from one time to the next</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this line is in the part that is to be reversed, and is not only a move</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this line is not executed (deleted, after the end, or never reached), so that its meaning is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot be held while its program runs: its link has no such command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot be jogged from here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot be jogged while a program is held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot be resumed over its link</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot be stopped while it runs the lines that it has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot do this: {word}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot find its own zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine cannot go back along its cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine does not report its position: it is calculated from the lines sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no Y axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no Z axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no Z axis: arcs are in XY</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no Z axis: take it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no output to switch (knife and point have no power): take it out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no probe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has no spindle whose speed is chosen: write M3 alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine has {axes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this machine's speeds cannot be changed while its program runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this material number is none of a material file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this one is made when that is done, in about a minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this pin of the machine is not known to this reader</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this program does not understand the answers of the session {session_file}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this reader knows no pockets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this setting can only be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this setting cannot be changed while the controller runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this shape has no holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this system has no Unix sockets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this takes long and is calculated in the background</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>those of splines count {spline_weight} times</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>threads can be cut only in the plane ZX</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>three times the bar's width</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>threshold {threshold}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>times its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tiny chains</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tiny chains were taken out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tip_diameter_mm must be below diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to end its process would not stop the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>to turn a side round use mirror</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many drawings, or one read in too many ways</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many ends of lines lie within {within_mm:g} mm of each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many lines and arcs in its files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many lines are on top of each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>too many points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool changes by a pause</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool must be a list of tables with a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {0}: {1} rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {each_number} '{each}' is left out: {notes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} '{name}' cannot be used: {notes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} '{name}': a table has no {lost}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} cuts on without a stop to change tool {number2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} has no shape: its moves are not simulated</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} is not quite that of its file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {number} is unknown, so that its cuts are not checked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {stored_number} of {form_file}: {note}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {tool_number} has no {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {tool} is not in the tool table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>torque must be points (rpm, Nm) that rise in rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>torque must not be below zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>travel_min_mm must be below travel_max_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>try again; if it stays so, the program may need more memory than there is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>try it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn it round, or take its outside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn the part from its beginning</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn the program instead</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn the spindle faster</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn the spindle slower</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turn with at most {most:.4g} rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turning (G7, G95, G96) is in force here: no entry is written for a lathe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turning clockwise (M3)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>turning counter-clockwise (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>twice the holes' distance from it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two arcs of the profile have one centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two chamfers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two commands of one line both use axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two flanges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two holes would meet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two legs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two lines of the profile are parallel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two parts lie too close to each other for the wire to pass, at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two rows are for {thickness:g} mm of {material}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two rules have the same title</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two self-squaring axes cannot be homed at the same time</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two shapes have the name '{shape}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two tools have the same number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two words of one modal group are in one line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two words of the line contradict each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two {of_what} have the same {key}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>undo that, choose another drawing, or choose none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unite them to one solid, and export it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unknown keys {unknown}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unknown: {home} before the restart; {until_homed}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unlock it ($X); where it stays locked, disconnect and connect again; then set its zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unlock it in the settings, or use another work system</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unlock it with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>until then nothing but homing, jogging and setting the zero is safe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>up to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>update its firmware</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use #&lt;_current_tool&gt;</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use 10 and 10</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G43 with the tool's number in H</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G43.1 with the length in Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G54 to G59</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G82, or leave dwell_s out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G83 or G73, or leave peck_mm out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use I and J instead of R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use ROUND[...]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use X or Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a FreeCAD of freecad.org, whose Python has all packages</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a boring bar</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a drill or a flat mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a flat tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a longer drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a longer one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a mill, an engraver, a jet or a wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a mill, or lift the drill before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a more pointed insert or a groove</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a name of your own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller kerf, or widen the web</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller nose</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller tool or one that plunges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller tool, a larger engagement_max_deg, or another pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller tool, or another contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a smaller tool, or round the corner off</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a speed between $31 and $30</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a steady rest, or at most {length:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a tailstock, or at most {length:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a thread mill with one tooth, given as an engraver with a large tip_diameter_mm or as flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a thread mill, given as an engraver or as flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a tool number up to 255</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a tool that the table has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a work offset (G54) instead</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use an engagement_max_deg of {deg} or more with a stepover_mm of {stepover_mm:g} or more, a smaller tool, or another pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use another blade</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use another holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use another insert or holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use another tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use entry "helix" or "ramp"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use entry "plunge"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use entry "ramp" or "plunge"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use larger steps or a smaller depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use method "tolerance" or a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use o, nu, na, {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of carbide</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of those that `$#` lists</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {consumables}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {cycles}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {dialect_names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {keywords}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {kinds}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {known}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {material_names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {materials}, or give a chart of your own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {operations}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {processes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {shapes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {there}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one that `$` lists</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one work offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use pattern "offset" or "zigzag"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use side "inside", "outside" or "on"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use the machine's own buttons</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use the version of CNCStepper that started it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use thicker sheets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use {functions} or ATAN</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>value {value}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait a moment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait a moment, then try again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait longer, hold or stop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it has ended, or stop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it has finished, or stop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it has started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it is at rest, or hold it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it is homed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until it is idle; after an alarm home it or unlock it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until the jog has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until the program that writes it is done, then begin again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait until the typed line is done, or stop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait, hold or stop it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>waits for {dwell_s:g} s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>waits need table_ms, or first_ms, change_ms and least_ms, or acceleration_steps_s2 and steps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wake it up with a reset, then home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>way out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>what lies inside an outline is faced with it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>where the machine is cannot be seen: every report of the controller is damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>where the tool is when a program of {dialect} begins is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>where this move began is not known, so there is no way back along it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>where this rapid begins is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>where this way begins is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>which run of line {number} is meant is not clear</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>while G80 is in force {dialect} takes no axis words, nor those of {user}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>width and height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>with tool {tool} in the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>with {share:.0%} of its move done</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>without a file, {total} lines to send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>without a lead-in the pierce lies on the cut, beside the part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>words for the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>words for this coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>words were left over that no command uses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>work_offset must be one of {work_systems}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write 0 where the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write ATAN[y]/[x]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write EXISTS[#&lt;name&gt;]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write F and S above 0 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write F on a line of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write F{feed:.6g} into the file: its controller reads it itself, and would take an earlier feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G0, G1, G2 or G3</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G17 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G17 before, or tap with G33.1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G17 on a line before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G17 or G18 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G17, G18 or G19 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G18 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G18 before that line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G4 P{delay_s:g} behind M3</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G4 P{needed_s:g} after the spindle starts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G40 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G43 or G49 after the change</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G5.2 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G5.3 on a line before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G90 (absolute) or G91 (incremental): they are the words for straight cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G90 first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G94 and an F word before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G94 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write KEY=VALUE, for example axis.x.steps_per_mm=80</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M2 or M30 as its last line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M5 ${0} before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M5 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M5 before M0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M5 before M0, and pierce again behind it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M70 before, in the same subroutine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write S before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write X and the seconds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write X; Z of each in a row</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write X; Z, then for example chamfer 1 or ccw radius 7</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write [MATERIAL_NUMBER_n] and below it lines such as: CUT_SPEED = 3850</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write [[operation]]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a G0 or G1 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a G0 with numbers before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a decimal number after the letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a finer pitch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a lead that is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a library, with the ending .fctl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a line G0 before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a line such as: T3 P3 D6.0 Z+41.5 ;6 mm end mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a move with G90 before it, or move the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a number within these bounds: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a number, #parameter or [expression]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a point for decimals</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a rapid to its begin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a rule for them, or one with ignore = true</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write a straight line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write an F word above 0 before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write an insert (CNMG120408, 16ER1.5ISO), boring:CCMT060204, parting:3 or drill:10; 2=drill:10 for tool 2</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write as the first line: {columns}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write both, as in: NAME = mild-steel 3 mm 45A</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write chamfer, fillet, cw radius, ccw radius or cw centre with their numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write distance = "absolute"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write each program so that it can run on its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write each turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write endsub, or M99 in a subprogram of Fanuc's form</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write feed= and mm/min, for example feed=900</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write fewer digits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write flatter tables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write for example XYZ, or Z alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write for grbl or linuxcnc</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write four letters and six digits, for example CNMG 120408</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write how many parts are wanted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it as two</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it in lines of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it in the controller's own: cncstepper convert PROGRAM --dialect {dialect} --to {own} -o NEW</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it in two lines, or make the comment shorter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it on a line of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write it on the next line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write its comment before, such as {example}, or name material and thickness</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write its end point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write its endif, endwhile, endrepeat, while or endsub</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write length_mm = {length:.4g}, or lengthen the cylinder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write numbers in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one of them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one of: {corner_of_origin}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one program a tool, or pause at tool changes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one such as M20x2.5, M20, 1/2-13 UNC, 1/4-28 UNF, 3/8-16 BSW, G1/2, Tr20x4 or Tr40x14P7</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one x,y in mm a line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write ph=, pd=, ch= and fr=</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write plain moves, each in a line of its own, in coordinates that are not turned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write rules: [[rule]]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write shape:diameter_mm, for example flat:6 or ball:2</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write socket://host:port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write tcp://127.0.0.1:8786, or tls://HOST:8786</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the arc with more decimals</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the chart as TOML</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the curve as lines and arcs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the cuts as [[operation]]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the end point itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the motion word again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the name of a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the path of the tool's centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program for the dialect fluidnc or grbl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program for the dialect grbl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program for the dialect grblhal or grbl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program for the dialect mini-lathe</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program in mm, or choose a higher feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the value itself</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the words with plain numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write them on two lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write those</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write to another one</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write with G54 to G59</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write x,y in mm, or x;y where the comma is the decimal sign</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write x_is = "radius"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {0} to {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {keyword} [condition]</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {key} = "file"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {key} = "name"</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {number} within these bounds: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {other} alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write {word} before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>x y width height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>x_is = diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>z {0} mm at most</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>zero of</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>zero of {axes} set in {system}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} (not offered)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} MB, {1} files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} and {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} by the template {1}, {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} by {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} by {1} to {2} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} cm³, {1} of the solid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} in islands {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm each where the axes are square</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} open edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} parts on {1} sheets, {2} m cut, {3} pierces, {4} hours of the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} parts without a place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} segments fewer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} sheets of {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} to {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} to {1} mm from here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} to {1} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} units an em</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} without a place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0}, program {1} of {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{absent} is absent: the axis stays here, but the published control would drive it to 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{asked}; a {other} is used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{away:.4g} mm beside it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{away_mm:.3f} mm away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{beyond_mm:.3f} mm beyond</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{body} goes into clamp {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{centre_word} is no centre word in plane {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{chain}: the kerf does not get into a slot or corner at X{x:.3f} Y{y:.3f}; {left_mm:.2f} mm stay</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{clear_mm:g} mm with the stock to leave</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{code} and {code2} may not share a line: they set the same mode</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{code} needs X, Y or Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{code} needs a {letter} word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{counts} at one place</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} characters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} clip paths and masks are not applied: the parts that they hide are read too</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} copies have {places} places</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} copies of {name} have no place on the work surface</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} dashed strokes are read as whole lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} joints do not fit on {chain}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} lines have markers, which are not read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} of {name}: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} paths are damaged and read up to the damage</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} pulses do not fit: no room, or ticks that do not rise</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} texts are longer than their path; letters beyond it are left out: {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} texts are set in another font or style than the file names: {names}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} texts with places inside their textLength are not brought to it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{count} transforms are damaged and not applied</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{crossing} rapid(s) lead over parts that are already free</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{cycle} needs a fixed speed of the spindle: take constant_surface_speed out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{deep_mm:.3f} mm deep</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{depth:.3g} mm deep, or {rpm:.4g} rpm, would do</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} answers {answer}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} cannot switch the power off between two cuts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} does not accept {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no axis {letter}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no programs in {units}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no word for X as a diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no word {letter}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no work offset {name}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} has no {what}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} programs are written without '{code}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{dialect} programs are written without '{event_kind}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{doing} failed by a fault of its own: {kind}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{doing} takes more memory than there is</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{doubles} boundaries of hatches are drawn as lines too; they are read once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{ends} of {curves} open, the first from {end}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{error}. Now {state}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{far_mm:.3f} mm away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{far_mm:.3f} mm from the tool's centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{feed_mm_min:g} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{field:g} to {field2:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{file}, {total} lines to send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{first_file}: restart that one again; its restart's cuts count as cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{first_mm:g} to {last_mm:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{gap_mm:g} mm each, the kerf included</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{hanging} piece(s) stay joined to others, for the tool does not fit between them; the tightest place is at X{x:.3f} Y{y:.3f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{high:g} by {high2:g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{holes} closed hole(s)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{home}, and end other programs before the next try</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{inside} of {runs} runs cannot be entered from the side; a {kind} is used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{interval} (work, mm)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{job} has no program: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{keeper} was refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{kerf_mm:g} mm from the other holes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{kerf_share:.4g} to {kerf_share2:.4g} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} cannot be '{value}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} cannot be {value}: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} goes beyond what the machine can travel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} goes far beyond the machine's fastest axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} goes far beyond the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} goes far beyond the stock and the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} has too few values</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} is missing, and only the circles of a drawing have one of their own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} is too long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} is twice in one material</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} leads into a value that is no table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} must be a list of tables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} must be a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} must be the name of a shape, or a list of names</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} must be {number} within its bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} must name a file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} names the shape '{name}' twice</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} names the shape '{name}', which the job does not have</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} needs X, Y or X, Y, Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} needs a closed shape, but '{name}' does not end where it begins</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} needs a laser: {process} has one power and pierces anew</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} of material {number}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key} of material {number} has no such value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key}= is twice in a material's comment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key}= of a material has no such value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{key}= of a material is out of its bounds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}, {size}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}{length}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{lacks} became lines, at most {chord_mm:g} mm away</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{late_ms:.0f} ms without a pulse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{late_ns:.0f} µs late</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{left:g} {operator} {right:g} is no finite number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{left_out} corner(s) get no loop: there is no scrap for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{left_out} messages were left out: more came than could be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{length_mm:.3f} mm to ramp on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{length_mm:g} mm, {feed_mm_min:g} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{length} characters, {text} with spaces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} continues from the last point: neither with {other} nor under G91</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} has no meaning with G10 L{kind}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} is out of range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} is twice on the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} may not be negative</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} must be a whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{letter} of {name} must be {word} 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{limit_mm:g} mm high</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{limit_ms:.0f} ms</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{line_characters} characters, {window_bytes} with spaces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{lines} lines more than the text has</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{line} has no {keywords} with the label {line2} before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{line} is in line {index} of {known_file} already</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{line} is outside any subroutine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} answered '{answer}' to no line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} does not answer {line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} does not report its modes: question or answer was damaged</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} restarted while it was asked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} runs grbl {version}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{link} sends no line ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} accepts no pulse letters</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} at {port}, grbl {firmware}, begun {begin}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} does not cut by {process}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} has a controller of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} has a laser, whose beam would not be in time with its moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} has no axis {axis}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} has no relay '{name}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{machine} takes no sheets: it has no Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{match} is no number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{meaning} (error:{error})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{missing} cut(s) end without a lead-out: there is no scrap for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{missing} is missing: absolute arc centres need both words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{moment}, OFF the path of these lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{moment}, on the path at line {seen_line}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{more} {rest_mm:.3f} mm of material stays in {corners} inside corner(s) that are sharper than the tool; {told}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{most_mm:.2f} mm each</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{most_strokes} moves in one block</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{most} pixels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{named} cannot change tools by '{tool_change}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} and {other} may not share a line: they use the same word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} asks for more than {most_passes} passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} became plain moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} cannot be had: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} cannot be used as a serial port: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} has no feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} has no feed: a feed per turn needs F and a spindle that turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} has no value for {argument:g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is a parallel port, and the machine is a board</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is a parallel port, on which there is no controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is between G5.2 and G5.3</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is in use</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is no object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is no port for pulses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is no port: {text}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is not read in {plane}, a plane of the axes U, V and W</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is not reported</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is read in the plane XY only: LinuxCNC moves along the wrong axes in {plane_code}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} is {offset}, wanted {wanted} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} lists no such alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} lists no such error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} may not be assigned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} may not be opened by this user</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} may not be used</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} moves with the spindle, whose speed is not set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs a {letter} word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs a {letter} word: none is in force</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs both I and J</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn clockwise (M3)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs the spindle to turn counter-clockwise (M4)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} needs the whole program: the profile is a subroutine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} sends more than was asked for</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} takes no F: the spindle drives it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} was set before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{name} works in the plane ZX</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{number:.0f} pulses/s, the worst {worst_us:.0f} µs late</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} follows one drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} follows one profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} has no '{unknown}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} has no drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} has no profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} has no tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{obj} is not cut by {process}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{one} and {other} cut into each other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{one} cuts into a piece that {other} has set free: nothing holds it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{owner} by way of a place cannot be turned</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{owner} sets the zero from where the tool stands after moves of the path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{package} is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} cannot be read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} cannot be recorded in: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} cannot be written: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} has no pins to read: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} is JSON: only TOML profiles are changed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} is no parallel port that can be had: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{path} is no recording of pulses, and is not written over</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{per_s:.0f} pulses/s, {stall_us:.0f} µs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{pierce_mm:g} mm from parts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{pierce_mm:g} mm from parts and cut edges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{places} of {wanted} tabs fit on the contour that begins at X{x:.3f} Y{y:.3f}; make them narrower to fit more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{plain} has no setting '{setting}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port} is connected as {there}, not as {machine}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port} is held by a job of yours, {status_file}, which is {phase}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port} is held by a process of yours that does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port} is in use by another window's connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port} may be held by another connection of yours</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{port}, grbl {firmware}, begun {begin}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{problem} in {table}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} does not cut through the sheet: it needs no tabs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} does not cut with a {shape} tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} does not cut with a {shape} tool; its shape is one of: {shapes}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} has no kerf and no power to test</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} is lowered and lifted, but the machine has no Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{process} takes no cut chart</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{program}, which is to be run before it, is refused</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{python} cannot be started: {error}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{says} is larger than the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{says} is no number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{says} is out of range</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{scrap_mm:.2f} mm of scrap there</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{skipped} other things</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{skipped} other things, the first: {why}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{stale} has changed since the program was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{state} at work {work}, machine {machine} mm, {moment}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{state}; it runs on for {left_s:.0f} s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{style} does not drill in pecks</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{style} does not wait at the bottom</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{style} drills in pecks and needs peck_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{style} waits at the bottom and needs dwell_s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{system} is not the work system in force</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{thick_mm:.3f} mm ({area_mm2:.3f} mm²) at X{x:.2f} Y{y:.2f}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{title} blunts tools of HSS at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{twice} curve(s) are drawn twice and are cut once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{twice} of the {drawn} holes are at the place of others and are made once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{unreachable_mm:.3f} mm of material stays at each end of the long axis, where the ellipse is tighter than the tool; a tool of at most {short_mm:.3g} mm diameter reaches it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{untaken} chains</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{user} and {user2} would both use the axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{value:g} must be a whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{wall_mm:g} mm radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{what} cannot be sent to a controller of this computer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{what} must be larger than {than}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{what} while the tool is compensated</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{what}, not {value}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{why}, at X {x:.4g} Y {y:.4g} Z {z:.4g}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{why}. Now {state}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{width_mm:.2f} mm from {begin_mm:.2f} mm on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{width_mm:g} mm wide</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{width} by {height}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{word} by the button on {button}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{word} is in force, wanted {wanted}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{xy} points, {bulge} bulges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>~ is a command to the controller (cycle start), not part of a program</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Arrangement</name>
        <message>
            <source>Arrange programs…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Places programs on the work surface with the mouse, and makes one program of them</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Bore</name>
        <message>
            <source>Bore</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cuts holes wider than the tool along helices: the selected circles</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_CircularPocket</name>
        <message>
            <source>Circular pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cuts a pocket: the selected circle, or one by numbers</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Contour</name>
        <message>
            <source>Contour</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cuts along the selected lines or faces: outside, inside or on</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Controller</name>
        <message>
            <source>Controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shows the machine: state, position, hold, stop, jog, zero</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Drill</name>
        <message>
            <source>Drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drills at the selected circles and points, or in a pattern</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Duplicate</name>
        <message>
            <source>Duplicate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Puts a copy of each selected operation behind it in the job</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_EditProgram</name>
        <message>
            <source>Edit program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Opens the program of the job in the editor</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_EllipticalPocket</name>
        <message>
            <source>Cuts a pocket: the selected ellipse, or one by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Engrave</name>
        <message>
            <source>Cuts along the lines of the selected drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engrave</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ExportJob</name>
        <message>
            <source>Export job…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writes the job as a file that cncstepper runs</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Face</name>
        <message>
            <source>Face</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Makes the top flat: of the stock, or of what is selected</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_FirstSteps</name>
        <message>
            <source>First steps…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Three ways to begin: a tour without a machine, your machine, an example</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Freehand</name>
        <message>
            <source>Draws a line with the mouse: press, move, release</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Freehand</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ImportDrawing</name>
        <message>
            <source>Brings in SVG, DXF, STEP, STL, pictures, points or G-code, linked to the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Import drawing…</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_ImportTools</name>
        <message>
            <source>Adds the tools of FreeCAD's library or of a tool table</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Import tools…</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Install</name>
        <message>
            <source>Install packages…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Installs the Python packages that are missing, from the internet or from files</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Letters</name>
        <message>
            <source>Draws a file of pulse letters and sends it, forwards and back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse letters…</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Machines</name>
        <message>
            <source>Machines…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Makes and changes machine profiles, and tests a machine</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_MoveDown</name>
        <message>
            <source>Cuts the selected operations after the one below them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move down</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_MoveUp</name>
        <message>
            <source>Cuts the selected operations before the one above them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Move up</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Nest</name>
        <message>
            <source>Nest on sheets…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Places the selected drawings on sheets of material, as often as they are wanted</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_NewJob</name>
        <message>
            <source>Makes a job. A selected solid or drawing gives its stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New job</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_OpenJob</name>
        <message>
            <source>Open job…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Opens a job file with its tools, operations and curves</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_OpenProgram</name>
        <message>
            <source>Open G-code file…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Opens a G-code file in the editor</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Pocket</name>
        <message>
            <source>Clears what the selected closed lines or faces enclose</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pocket</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_RectangularPocket</name>
        <message>
            <source>Cuts a pocket: the selected rectangle, or one by numbers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rectangular pocket</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Send</name>
        <message>
            <source>Checks the program of the job and streams it to the machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Shapes</name>
        <message>
            <source>Adds a shape by its dimensions: holes, slots, flanges, brackets</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shapes…</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_SheetCut</name>
        <message>
            <source>Cuts parts out of sheet by torch, laser, jet, knife or point</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Sheet cut</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Simulate</name>
        <message>
            <source>Check and simulate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Checks the program of the job and shows what it cuts</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Slices</name>
        <message>
            <source>Cuts a solid into sheets with registration holes, and nests their pieces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Slice a solid…</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Text</name>
        <message>
            <source>Adds a text in any font, or in single lines for engraving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Text</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Thread</name>
        <message>
            <source>Mills threads at the selected circles, or in a pattern</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Thread</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_WireCut</name>
        <message>
            <source>Cuts parts out of foam with a hot wire, in from the edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Wire cut</source>
            <translation type="unfinished"></translation>
        </message>
    </context>
</TS>
