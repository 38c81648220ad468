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
            <source>Centre</source>
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
            <source>Coolant</source>
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
            <source>Ellipse</source>
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
            <source>Feed at the wall</source>
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
            <source>First half axis</source>
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
            <source>Length, width and height</source>
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
            <source>Second half axis</source>
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
            <source>Stock Origin</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Stock Size</source>
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
            <source>The drawing it followed, when that was deleted</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
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
            <source>What is cut, in this order</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
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
            <source>Connect to the controller at this port</source>
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
            <source>Controller</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Coolant</source>
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
            <source>Direction</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Disconnect</source>
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
            <source>Engrave</source>
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
            <source>Feed at the wall</source>
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
            <source>Finding</source>
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
            <source>First half axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Fit to drawing</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
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
            <source>Go on</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Go on after a hold, a pause or the door.</source>
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
            <source>How many times faster than a real one the virtual machine moves</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>How many times faster than the machine</source>
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
            <source>Keep cutting and close</source>
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
            <source>Leave out of the program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Length, width and height</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Let go of the controller</source>
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
            <source>No port can be opened here.</source>
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
            <source>Of the written program</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One line of the program back</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>One line of the program on</source>
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
            <source>Put the stock around what is selected, or around the drawings of the operations</source>
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
            <source>Second half axis</source>
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
            <source>Take selected</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Take the alarm away without homing: only when the position is surely right.</source>
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
            <source>What is switched on while cutting</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>Where</source>
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
            <source>limit {0}</source>
            <translation type="unfinished"></translation>
        </message>
        <message>
            <source>line {0}</source>
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
