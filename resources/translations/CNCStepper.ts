<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre</source>
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
            <source>Closed</source>
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
            <source>Coolant</source>
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
            <source>Corner Radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting</source>
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
            <source>Dialect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge Margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Engagement Max</source>
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
            <source>Entry angle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed</source>
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
            <source>For a mill that does not cut over its centre; 0: 10°</source>
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
            <source>From X to the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest engagement</source>
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
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
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
            <source>How many teeth; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Kept</source>
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
            <source>Least chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length, width and height; of a cylinder, which stands, the length is its diameter</source>
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
            <source>Line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line Length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine</source>
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
            <source>Number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the written program</source>
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
            <source>Outlines of the clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Plunge</source>
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
            <source>Preview</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Problem</source>
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
            <source>Radius X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Radius Y</source>
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
            <source>Ramp Max</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Recalculated to whole passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Solids that hold the work down, which the tool must not touch</source>
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
            <source>Spindle turns a minute</source>
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
            <source>Taper</source>
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
            <source>The clamps seen from above, at the height of their tops</source>
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
            <source>The depth of one pass at most; 0: all at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of the pocket, ap_total</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of what holds the tool; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
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
            <source>The job whose program is shown</source>
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
            <source>The length of all lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The middle of a mill's end that does not cut; 0: it cuts over its centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the clamps move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
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
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed straight down</source>
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
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
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
            <source>Tolerance</source>
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
            <source>Tools</source>
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
            <source>Wall feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is cut, in this order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the raw material looks like</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
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
            <source>Why it cannot be made; empty when it can</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Why there is no program</source>
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
            <source>Work zero</source>
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
    </context>
    <context>
        <name>CNCStepper</name>
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
            <source>'{0}' is no value in {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A controller is connected already.</source>
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
            <source>A machine's profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A profile's file…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A serial port, or an address as socket://192.168.0.7:23</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A tool of this shape has none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>A value is missing here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Active</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add a tool to this job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add selected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add the part, as it stands now, to the document as a mesh</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Add tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Alarm</source>
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
            <source>An expression gives this value; change it in the property editor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Another machine?</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Attached again to the controller at {0}.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a V-bit or engraver; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Between the two sides of a drill's point; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Busy</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper has a fault: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Centre</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Change the programmed value while cutting, in percent.</source>
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
            <source>Choose one here</source>
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
            <source>Connecting…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Connection lost</source>
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
            <source>Controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Core diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Corner radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cut in this order; what is not checked is left out of the program</source>
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
            <source>Cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Cutting the part…</source>
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
            <source>Direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect first: this is what the dock is connected to.</source>
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
            <source>Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done.</source>
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
            <source>Drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Earlier</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edge margin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edit</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Edit {0}</source>
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
            <source>Engraving</source>
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
            <source>Error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Failed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Feeding in air</source>
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
            <source>Finish</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Finishing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fit to drawing</source>
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
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>For a mill that does not cut over its centre; 0: 10°</source>
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
            <source>FreeCAD's Python lacks numba. All works without, but planning and simulating are slow.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks pyserial. No machine can be reached without.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No program can be made without.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>From the tip to the holder; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go on after a hold, a pause or the door.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Greatest engagement</source>
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
            <source>Height above the top of the stock; lines: where the tool's tip goes</source>
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
            <source>Hold</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Hold: slow down and stand still; nothing is lost, the spindle goes on turning.</source>
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
            <source>Home</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Homing works only while the machine is idle or in alarm.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far from the stock's edge cuts must stay; 0: the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far one click moves the machine.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How fast the machine moves while jogging; it never goes faster than it can.</source>
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
            <source>How many teeth; 0: not given</source>
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
            <source>How much of the rim may be in the material, as an angle; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Is the work zero set on the stock and the way free?</source>
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
            <source>Least chip load</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Leave out of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length, width and height; of a cylinder, which stands, the length is its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lengths and limits</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Let go of the controller.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Let the machine find its own zero with its switches.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Levels</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Line length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Lines</source>
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
            <source>Looking for a Python…</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make a job first, with New job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Make this position the work zero of the axis.</source>
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
            <source>Motor steps: {0}</source>
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
            <source>Move the machine in this direction.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>New job</source>
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
            <source>No messages yet</source>
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
            <source>Note</source>
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
            <source>Number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of a bull nose; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of one wall that a jet or wire leaves, against the vertical; 0: none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Of the written program</source>
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
            <source>Open or make a document first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Open the 3D view of the document first</source>
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
            <source>Outlines of the clamps</source>
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
            <source>Passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Paused</source>
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
            <source>Port</source>
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
            <source>Programs ({0})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Pulse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Put the stock around what is selected, or around the drawings of the operations</source>
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
            <source>Rapid</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rapids</source>
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
            <source>Recalculated to whole passes</source>
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
            <source>Release to close the line. Esc: give up this line.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Remaining</source>
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
            <source>Resolution</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Resume</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Retract</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Running</source>
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
            <source>Select a drawing in the tree or in the 3D view first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select a drawing or a solid first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select one or more solids first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select the job in the tree: this document has several</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Select what is to be engraved: a sketch, a wire, a B-spline or a freehand line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Send anyway</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Show the tool's path</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Simulate again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Size</source>
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
            <source>Speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Spindle turns a minute</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Start</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Starting</source>
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
            <source>Stock</source>
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
            <source>Stop: slow down, stand still, spindle off; the rest of the job is not cut. This is not an emergency stop: the emergency stop is on the machine.</source>
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
            <source>Switch {0}</source>
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
            <source>Take the alarm away without homing: only when the position is surely right.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the solids that are selected for clamps</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Taper</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The T word of the program</source>
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
            <source>The clamps seen from above, at the height of their tops</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The connection is being made.</source>
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
            <source>The cut goes on without FreeCAD; the controller's panel finds it again the next time it is opened.</source>
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
            <source>The depth of one pass at most; 0: all at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The depth of the pocket, ap_total</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The diameter of what holds the tool; 0: not given</source>
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
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
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
            <source>The job is being cut.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
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
            <source>The length of all lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The length of the cutting edges; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The link to the controller is being started.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine is cutting a job.</source>
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
            <source>The machine stands and waits.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The machine stands; nothing is lost. Resume or stop.</source>
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
            <source>The parts and bodies that the clamps move with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The program has changed since: what is shown is the one before.</source>
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
            <source>The program waits. Resume goes on.</source>
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
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The speed straight down</source>
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
            <source>The thinnest chip of a tooth, below which it rubs; 0: not given</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
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
            <source>This machine has no homing switches set up ($22=0).</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>This takes a number without a unit, not '{0}'</source>
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
            <source>Timing the moves…</source>
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
            <source>To get what is missing, type in a terminal, with Python {0}, and start FreeCAD again:</source>
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
            <source>Tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Tools</source>
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
            <source>Unreachable</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>V-bit</source>
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
            <source>What is cut, in this order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is one step: a line of the program, a move, or a pulse of the motors</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the raw material looks like</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the table stands is not known: home the machine, or set the work zero anew.</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
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
            <source>While pressed</source>
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
            <source>Work</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Writing the report…</source>
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
            <source>arcs within the tolerance</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ball end mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bull nose</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>centre of the top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>climb</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>conventional</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cylinder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>drill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>engraver</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>feed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flat end mill</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flood (M8)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>front left corner of the top</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>helix</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>inches (G20)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jet (water, plasma, laser)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>limit {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make room in the folder for temporary files</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>millimetres (G21)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mist (M7)</source>
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
            <source>none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none yet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>none, the numbers count</source>
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
            <source>published points (DDA)</source>
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
            <source>sheet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>straight down</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's own</source>
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
            <source>value {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wire</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} %</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} = 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has nothing to cut: add an operation</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is cut with it; choose another tool there first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} of {1} lines, line {2} of the file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} rpm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} ×</source>
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
            <source>{0}:</source>
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
    </context>
    <context>
        <name>CNCStepper core</name>
        <message>
            <source>${0} is {1}, wanted {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' cannot be {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no origin of a stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is no solid and cannot be a clamp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' is not a tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' names no axes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' names no port number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>'{0}' stands on this job and cannot be its clamp</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>0 to {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>CNCStepper certificate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G43.1 may move only the tool-length axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>G53 works only with G0 and G1</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Reset to continue</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a P or L value is missing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a bulge is not that of an arc in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a chip load needs flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a coordinate is not a length in mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a curve needs at least two points and a bulge for each segment</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cut goes into stock while the spindle stands</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a cutting move begins at an unknown position, so it is not checked against the stock</source>
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
            <source>a drill goes sideways through stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a height field needs two rows and two columns of finite heights at least</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a job runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a jog needs a way and a feed</source>
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
            <source>a mill that does not cut over its centre ({0}) goes down into stock too steeply</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a move would end outside the travel (soft limit)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a number is missing or cannot be read</source>
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
            <source>a request without the session's token</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a scale must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a setting asks for more steps a second than the controller can give</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tolerance must be above 0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a tooth of the {0} tool takes too thick a chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a value is negative where only positive ones are allowed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word does not begin with a letter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a word stands twice in one line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {0} tool has no {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>a {0} tool leaves no flat floor</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>above 0 mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the missing pass, or lower the stepover or the stepdown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add the tool or correct the T word</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>add yourself to its group (sudo usermod -aG dialout $USER) and log in again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>all {0} lines are cut, the machine is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>an offset came damaged: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>another task is open in the task panel</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>ask for the right to use it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>at least {0} mm</source>
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
            <source>axis words stand where no command uses them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>axis.{0} is missing</source>
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
            <source>below {0} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>both radii must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>bring it to Idle first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check both switches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and baud rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable and power; home the machine or set its zero again before the next cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>check cable, power and other programs on this port</source>
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
            <source>check the cable</source>
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
            <source>check the switches, and travel $130 to $132</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>chip_load_min_mm must not exceed chip_load_max_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose S from {0} to {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a folder that exists and that you may write to</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a sketch, wire, B-spline or freehand line for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose a solid, for example a box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose another</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of the job's tools for it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose one of: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>choose the right machine profile, or correct the settings</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>clearance_mm must not be below retract_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it and home again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>close it or set closed = false</source>
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
            <source>core_diameter_mm must not exceed diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>corner_radius_mm must not exceed half of diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct its spelling or take it out; known are: {0}</source>
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
            <source>correct that line of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct that value</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the jog command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the path, the tool's diameter or the depth</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct the program, and check it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>correct work zero or program, then unlock with $X; the position is kept</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>curves do not meet</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>cut in more levels, or take a longer tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw at least two points</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw it on the XY plane or on one parallel to it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>draw something in it, or choose another drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>edge_mm must not be below zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enable homing ($22=1) or switch soft limits off ($20=0)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>end it in .gif, or install ffmpeg</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>enter by a helix or ramp, or in the middle of a hole drilled before</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>exclusively lock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>find the cause, then home the machine: its position is lost</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish_stepover_mm (ae_acab) is larger than the tool's radius allows</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>finish_{0} leaves nothing to rough</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>flute_length_mm must not exceed length_mm</source>
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
            <source>give X,Y,Z in mm, for example 100,70,20</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a TOML file or one of: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a device name or socket://host:port</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a finite number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give a way of 0.0001 mm or more and a feed above 0</source>
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
            <source>give every row as many</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give heights over the bottom, and the largest as the stock's Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its diameter for X and for Y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give its {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the path of a TOML job file</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the stock and the tools</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the timeline its machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the tool a {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give the work zero to have the travel checked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>give two opposite corners of a rectangle, or three and more of a polygon in their order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>heights belong to a stock of the form 'height_field', and to no other</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>heights differ by {0} mm</source>
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
            <source>home the machine, or unlock it with $X</source>
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
            <source>homing was interrupted by a reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it for the Python that proves (python -m pip install NAME)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it: python -m pip install platformdirs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install it: python -m pip install pyserial</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>install them in one (python -m pip install {0}), or set {1} to a Python that has them</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it ended with an error</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>it has: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>jog less far</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>laser mode needs a variable spindle output</source>
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
            <source>leave the N words out</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>leave the check mode with $C</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>let the tool stick out farther</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the tool before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lift the tool over it, move the clamp or move the shape</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look at its switches</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>look the code up in the controller's documentation</source>
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
            <source>lower steps/mm or maximum rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the feed here, or the axis' rate and acceleration in controller and profile</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>lower the stepover, enter by a helix, or leave less in the corners</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make finish_{0} smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make it smaller, or islands remain</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make resolution_mm larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the passes, the levels, the resolution or the entry angle larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make the program smaller, split it, or use a larger machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>make {0} larger</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>material is left where it should be removed{0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>mend that object first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>more of the {0} tool's rim is in the material than it may</source>
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
            <source>move the work zero {0} the {1} axis or make the program smaller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>name X and Y in a rapid above the stock first</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no encoder for '{0}' is installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no feed rate was set</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>no parallel curve that far inside</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nobody has confirmed the work zero</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a JSON file: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a TOML file: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a curve with xy and bulge: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a job to send: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not a job: the file holds no object</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not finite: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>not the numbers of a curve: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing answers</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing answers at {0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing is known that could be asked so</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>nothing moves that could be held</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only a closed curve can start elsewhere</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>only {0} of {1} bytes were taken</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>operation '{0}' uses tool {1}, which the job does not have</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>part of the drawn shape lies beside the stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>platformdirs is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>please report it, with the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>plug the controller in, or give one of the ports that are there: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>points are not pairs of x and y</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prepare the program again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>prove parts of the program alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pulses are those of a machine</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>pyserial is not installed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>radii and resolution must be positive</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise F, or turn the spindle slower</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>raise the pull-off $27 or check the switch</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>remove it; only plain ASCII without ? ! ~ may be sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resolution_mm is too coarse for the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>resume what it was doing, or reset it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>run 'make setup' beside the workbench, or let Tools &gt; Addon Manager install them, or install them for Python {0}.{1} into a folder of their own (pip install --target FOLDER) and name it in the environment variable CNCSTEPPER_PACKAGES</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see its log, report it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>see whether it is whole</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>send another one</source>
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
            <source>set it again, and do not start before it is right</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>set the machine's settings again</source>
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
            <source>soft limits need homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>something else than grbl answers</source>
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
            <source>start it with cncstepper send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start it, or correct the URL</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start nearer to the part, then unlock with $X</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>start the spindle with M3 and S before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stepover_mm (ae) is larger than the tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stop with M5 and M0 before the new tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stopped as asked after {0} lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>stopped before the first line was sent</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it off with M5 before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>switch it on with M3 and S before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>take out {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the $ command is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc has no axis word of its plane</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the arc lacks its centre offset in the plane</source>
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
            <source>the beam is never on where it is to cut</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate cannot be read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate is of another version</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate lacks what a sender needs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the certificate was changed after it was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the character {0} would act as a command of its own or is not ASCII</source>
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
            <source>the controller does not answer any more</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not come back from its reset</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not know this command</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report ${0}: it was not compared</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not report its {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not say its work system: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller does not tell its state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller is idle but has not answered '{0}'</source>
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
            <source>the controller raised an alarm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused '{0}': {1} (error:{2})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused the line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller refused {0}: {1} (error:{2})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted in the middle of the job</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller restarted when its port was opened; it counts from where it stands</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller said: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller sleeps and its motors are off: unlock it, then home it or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the controller was reset while moving</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the corners of a clamp enclose nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the curve is not smooth here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut begins without waiting for the spindle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the cut comes too near to the sheet's edge</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk cannot be started: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk failed by a fault of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk of {0} is not there, or was killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the desk's process does not come up</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{0}' does not lie flat</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{0}' holds a line that is no ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{0}' holds more than one ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{0}' holds no lines</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the drawing '{0}' that it followed was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ellipse in '{0}' is open</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the feed asks more of {0} than its highest rate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the heights do not fit their box</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the holder</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the holder of the {0} tool goes into stock</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job cannot be read: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job has no operations</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the job was deleted</source>
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
            <source>the jog was stopped: its button was not heard of for {0} s</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the jogs before this one are not done yet</source>
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
            <source>the line has no length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line is longer than grbl can read</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the line is too long</source>
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
            <source>the lines to send are not those that were proven</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the link to {0} broke: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine does not end its homing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine does not home: {0} (error:{1})</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine has no {0} coolant</source>
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
            <source>the machine jogs only while it is idle</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine stands, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the motor of {0} may lose steps: at {1} mm/s ({2} rpm) and {3} mm/s² it has too little torque</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the move leaves the travel of {0} by {1} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the operation is too long for one program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the pocket is too narrow for a {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the points of a freehand line lie at different heights</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe touched nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the probe was not in its start state</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that knows the part at every moment has ended</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that proves cannot be started</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the process that proves the program ended without an answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program cannot be written: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program has no line to send</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is larger than the travel of {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program is not the one that was proven: its text differs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program moves nothing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program pauses while the spindle turns</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the program was proven for another machine, or its profile was changed since</source>
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
            <source>the proof failed by a fault of its own: {0}: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the proof found {0} error(s) in the program, the first: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the resolution is too fine for the ellipse</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the rows of heights differ in length</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the safety door is open or the machine is parking ({0}): resume later</source>
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
            <source>the second limit switch of a double axis was not found</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender failed by a fault of its own</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender's process does not answer</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender's process does not come up</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the sender's process ended at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session refused {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session still runs</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session {0} is not there, or was killed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the session's log</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the shank of the {0} tool rubs along the wall over its flutes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the spindle cannot turn at this speed</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the step pulse is shorter than 3 microseconds</source>
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
            <source>the timeline failed by a fault of its own: {0}: {1}</source>
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
            <source>the tool cuts into the wanted part</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool goes below the stock and cuts what lies under it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is below the stock's top while its place in X or Y is not known</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool is wider than the pocket</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the tool number is too large</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the value must be a whole number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the virtual grbl ended at once</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the wall may be up to {0} mm off: an ellipse is no offset of an ellipse, and the resolution adds to it; method "tolerance" keeps to tolerance_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work systems G59.1 to G59.3 do not exist here</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the work zero is not known, so the program's place on the table is unknown</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the zero of {0} in {1} was not taken over</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {0} tool cuts deeper than its flutes are long</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {0} tool is too small against its path for its engagement to be measured</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {0} tool rubs: a tooth takes too thin a chip</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>the {0} tool's form is not given, so it is judged as a flat one of its diameter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no command '{0}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no cycle '{0}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no job file '{0}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no key {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no machine profile '{0}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no override {0} {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no part to draw</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>there is no port {0}</source>
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
            <source>this client is detached</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>this is no certificate</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tip_diameter_mm must be below diameter_mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {0} cuts on without a stop to change tool {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {0} has no {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>tool {0} is not known, so what it cuts is not checked</source>
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
            <source>two commands of one line both want axis words</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two tools have the same number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>two words of one modal group stand in one line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>undo that, choose another drawing, or choose none</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>unknown keys {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>update its firmware</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use G54 to G59</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use I and J instead of R</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a flat tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a mill, or lift the drill before it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use a tool number up to 255</source>
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
            <source>use method "tolerance" or a smaller tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one of: {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>use one that `$` lists</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>wait a moment</source>
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
            <source>wake it up with a reset, then home it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>words were left over that no command uses</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>work_offset must be one of {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write 0 where the edge does not matter</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write G4 P{0} after the spindle starts</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write M5 before M0</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write for example XYZ, or Z alone</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write one of: {0}</source>
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
            <source>write the arc with more decimals</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>write the program for the dialect grbl</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>zero of {0} set in {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} answered '{1}' to no line</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} asks for more than {1} passes</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} cannot be '{1}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} cannot be started: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} cannot be used as a serial port: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} cannot be {1}: {2}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} characters, {1} with spaces</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} does not answer {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} goes into clamp {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has changed since the program was made</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has no '{1}'</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has no drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has no program: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} has no tool</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is in use</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is in use by another window's connection</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is no port: {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is not the work system in force</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} is {1}, wanted {2} mm</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} may not be opened by this user</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm high</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm of material stays at each end of the long axis, where the ellipse is tighter than the tool; a tool of at most {1} mm diameter reaches it</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm radius</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm, {1} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} mm/min</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} must be a list of tables</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} must be a number</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} needs X, Y or X, Y, Z</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} points, {1} bulges</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} restarted while it was asked</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} runs grbl {1}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} sends no line ends</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>{0} to {1} mm</source>
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
</TS>
