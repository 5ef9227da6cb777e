<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New &amp;Theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with the empty theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with empty ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Collect Assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene with copies of all its models beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring in an animated glTF model to paint with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;mport Stage…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring in a glTF model to stand on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave Crowdbrush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select everybody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select nobody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select those who are not selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Frame Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the F&amp;ront</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the scene from the front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the scene from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From Abo&amp;ve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the scene from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Perspective or Orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change between perspective and orthographic projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep This View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a camera of the scene where the view is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat &amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gr&amp;ound Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a grid of metres on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sha&amp;dows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light the scene; otherwise plain colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the brush larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the brush smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Crowdbrush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this is, and its version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn, shift and zoom the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O&amp;rientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Camera &amp;9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look through the scene&apos;s camera of this number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the present view as the scene&apos;s camera of this number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture &amp;Only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide panels and tool bar, or show them again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python &amp;Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type Python, with the open scene as &quot;scene&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run Script…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a Python file on the open scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the script that runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What mouse buttons and keys do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed: × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;End Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pat&amp;hs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show places and paths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show who has which tag by a coloured disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the start, everybody where the scene has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play faster, up to 8 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play slower, down to a tenth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep Pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put everybody in the scene where they are now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Welcome Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready-made scenes, new scenes, and what was open before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint places on the ground that make a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>En&amp;vironment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Untag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ecord Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write down as Python what is done by hand from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint with a brush that a script brought along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scr&amp;ipt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint obstacles, attractors, exits, slow, forbidden and liked ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking St&amp;yle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step, then pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path That &amp;Ends at the Last Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path Going &amp;Round and Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A path over the selected places, and on to the first one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path &amp;Jumping to the First Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add from &amp;Library…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose built-in characters to paint with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import Templates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put on the &amp;Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A path over the selected places, in order; characters stop there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A path over the selected places; characters jump from its last place to its first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the selected characters and places; everything when nothing is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create characters only on free seats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;Brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set all brushes as they were in the beginning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select characters, move them, delete them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spray new characters into the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spray characters away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recolour the characters under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the characters under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the characters under the brush another animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the characters under the brush walk along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set with which clip and how fast characters walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let an event happen to the characters under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag the characters under the brush, for rules to ask for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a tag off the characters under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put those of the selected characters, or of all, who stand where nobody can walk on the nearest ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put all panels back, and show in the picture what was shown at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the characters under the brush taller or stouter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material (te&amp;xtures)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the characters under the brush other materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme, mouse, autosave, memory, language, shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Group Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new group of the selected characters; it becomes active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the characters under the brush into a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select Si&amp;milar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also those who look like one of the selected: template, materials, colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grow Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also those who stand beside the selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sh&amp;rink Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without those who stand beside somebody not selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select with a &amp;Lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shu&amp;ffle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the characters under the brush exchange what they have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange who the characters under the brush are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the characters under the brush what another one has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide hats, bags and other parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push, gather, spread or comb the characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sm&amp;ooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the characters under the brush become like their neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the characters under the brush begin sooner or later: waves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the view as a picture, in any size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the characters under the brush back what they had</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Walkable Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show where characters can walk by a colour on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rules and Cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the panel of what characters do when, and of its cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall State &amp;9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep State &amp;9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep how the crowd is now, or who is selected, as the state of this number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give everybody back what he had in the state of this number: while it plays in this run alone, else in the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Emotion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint how the characters under the brush feel, or another feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Outfit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dress the characters under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grow to R&amp;elated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select also those who are related to one of the selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;uplicate Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected characters beside themselves, with the relations among them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show by arcs to whom the selected are related; all of them where nobody is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;lation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relate characters: friends, families, couples, leaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quick Reference Card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the shadows of people and stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was recalled in this run alone: Stop gives the scene back. Undo once more takes back: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everybody as they were one step before, then pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Latest Moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From an earlier moment back to where the run has come</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Mo&amp;vie…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write what has been played, or the scene, as a movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ecord into the Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cues, states and events become marks as they are performed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A marker in the timeline at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Former Mar&amp;k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the moment of the mark before this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the moment of the mark after this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time&amp;line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the panel of what happens when while it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play &amp;from Here On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is played begins at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play &amp;until Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is played ends at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play &amp;All Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play neither begins nor ends early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play &amp;Over and Over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the end of what is played it begins again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the Be&amp;ginning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first moment of what is played, or has been</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last moment of what is played, or has been</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take It from &amp;Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Camera as Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this moment of the timeline on the camera looks as the view does now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the T&amp;imeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view looks through the timeline&apos;s camera, where there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep Ta&amp;ke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what has been played, to be shown again as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;etake Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a take, they do something else in the play range, or from the moment shown on; everybody else does what he did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show Ne&amp;xt Take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One take after the other, then the scene as it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;kes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs that were kept: show, compare, take parts again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reta&amp;ke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the characters under the brush do it again while all others do what they did in the take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the name of an action, a brush, a panel or a setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run goes on from the moment shown, and what came after it is forgotten; out of a take another run goes on from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a line round those to select, or to paint with a brush; else a rectangle, or a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Undone: %n short stroke(s)</source>
        <translation>
            <numerusform>Undone: %n short stroke</numerusform>
            <numerusform>Undone: %n short strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done again: %n short stroke(s)</source>
        <translation>
            <numerusform>Done again: %n short stroke</numerusform>
            <numerusform>Done again: %n short strokes</numerusform>
        </translation>
    </message>
    <message>
        <source>End the path, line or area that is being drawn</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BrushStart</name>
    <message>
        <source>Click the character that the others are to be like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first stroke makes a new group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No group is chosen: strokes take characters out of theirs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No script has brought a brush along yet: run one in the Python console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose in the settings which templates characters become</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose in the settings which state characters get back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No take is shown: keep what was played, then choose it in the Takes panel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BrushTexts</name>
    <message>
        <source>Seats filled, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate, a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seats filled: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate: %1 a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction: %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed: × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of them, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance: %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete: %1 % of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by: %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking speed, m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking speed: %1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius: %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters per m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density: %1 characters per m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height: × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the wave, m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wave: %1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay: %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width: %1 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>The stroke was taken back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left: point · Middle: circle · Right: rectangle · Alt or Space and drag: navigate · [ ]: size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click somebody to take the colour · Escape: not now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the point to face · Escape: not now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right button: brushes · Alt or Space and drag: navigate · [ ]: size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No script brush is there yet: a script brings one along with crowdbrush.register_brush.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters created</source>
        <translation>
            <numerusform>%n character created</numerusform>
            <numerusform>%n characters created</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters deleted</source>
        <translation>
            <numerusform>%n character deleted</numerusform>
            <numerusform>%n characters deleted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters coloured</source>
        <translation>
            <numerusform>%n character coloured</numerusform>
            <numerusform>%n characters coloured</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters turned</source>
        <translation>
            <numerusform>%n character turned</numerusform>
            <numerusform>%n characters turned</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters walk differently</source>
        <translation>
            <numerusform>%n character walks differently</numerusform>
            <numerusform>%n characters walk differently</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters walk in another way</source>
        <translation>
            <numerusform>%n character walks in another way</numerusform>
            <numerusform>%n characters walk in another way</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters tagged</source>
        <translation>
            <numerusform>%n character tagged</numerusform>
            <numerusform>%n characters tagged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters without the tag</source>
        <translation>
            <numerusform>%n character without the tag</numerusform>
            <numerusform>%n characters without the tag</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters heard it</source>
        <translation>
            <numerusform>%n character heard it</numerusform>
            <numerusform>%n characters heard it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters changed</source>
        <translation>
            <numerusform>%n character changed</numerusform>
            <numerusform>%n characters changed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: create characters · + −: how many · Ctrl+click: more of the kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: delete characters · + −: how fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: colour characters · + −: strength · Ctrl+click: take the colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: turn characters · + −: direction · Ctrl+click: the point to face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: change what characters do · + −: speed · Ctrl+click: take the clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: let characters walk along the path · + −: walking speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: set how characters walk and how fast · + −: speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: tag characters · + −: which tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: take the tag off characters · + −: which tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: let an event happen to characters · + −: its number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: let the script change characters · Escape: take it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: scale characters · + −: how tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters scaled</source>
        <translation>
            <numerusform>%n character scaled</numerusform>
            <numerusform>%n characters scaled</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give characters other materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters given another material</source>
        <translation>
            <numerusform>%n character given another material</numerusform>
            <numerusform>%n characters given another material</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: take characters into the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters taken into the group</source>
        <translation>
            <numerusform>%n character taken into the group</numerusform>
            <numerusform>%n characters taken into the group</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters restored</source>
        <translation>
            <numerusform>%n character restored</numerusform>
            <numerusform>%n characters restored</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: let characters exchange what they have</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters shuffled</source>
        <translation>
            <numerusform>%n character shuffled</numerusform>
            <numerusform>%n characters shuffled</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give characters another template</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters given another template</source>
        <translation>
            <numerusform>%n character given another template</numerusform>
            <numerusform>%n characters given another template</numerusform>
        </translation>
    </message>
    <message>
        <source>Ctrl+click: whom to clone · Drag: give characters what that one has</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters made alike</source>
        <translation>
            <numerusform>%n character made alike</numerusform>
            <numerusform>%n characters made alike</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: show or hide parts of characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters given other parts</source>
        <translation>
            <numerusform>%n character given other parts</numerusform>
            <numerusform>%n characters given other parts</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: push characters about</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters pushed</source>
        <translation>
            <numerusform>%n character pushed</numerusform>
            <numerusform>%n characters pushed</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: let characters become like their neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters smoothed</source>
        <translation>
            <numerusform>%n character smoothed</numerusform>
            <numerusform>%n characters smoothed</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: set when characters begin · + −: seconds, or the wave&apos;s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters begin at another time</source>
        <translation>
            <numerusform>%n character begin at another time</numerusform>
            <numerusform>%n characters begin at another time</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · Ctrl+click: take it from somebody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click somebody to set the brush by · Escape: not now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to take there for this brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters move differently</source>
        <translation>
            <numerusform>%n character moves differently</numerusform>
            <numerusform>%n characters move differently</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give back what they had</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: paint what characters are like · Ctrl+click: take it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: dress characters · Ctrl+click: take the outfit</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters dressed</source>
        <translation>
            <numerusform>%n character dressed</numerusform>
            <numerusform>%n characters dressed</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag from one to another: relate them · Ctrl+drag: take it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Feature of %n characters changed</source>
        <translation>
            <numerusform>Feature of %n character changed</numerusform>
            <numerusform>Feature of %n characters changed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Relations of %n characters changed</source>
        <translation>
            <numerusform>Relations of %n character changed</numerusform>
            <numerusform>Relations of %n characters changed</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: choose who does it again; they begin when you let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters do it again…</source>
        <translation>
            <numerusform>%n character does it again…</numerusform>
            <numerusform>%n characters do it again…</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken: %1. The other characters are not ticked any more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Nobody under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No free seat under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a template to create first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen template is not loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too steep to stand on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to stand on under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others are nearer than the minimal distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The area is too large for this density: zoom in or lower the density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The area is too small for anybody at this density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them already have this colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has the chosen slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them already face this way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them already move like this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has a chosen clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brush is set to change nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to show the direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No free seat of the chosen rows and wedges under the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So small a share of them is nobody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them already walk like this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them already have this tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has this tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The script brush changed nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Create %n character(s)</source>
        <translation>
            <numerusform>Create %n character</numerusform>
            <numerusform>Create %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n character(s)</source>
        <translation>
            <numerusform>Delete %n character</numerusform>
            <numerusform>Delete %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour %n character(s)</source>
        <translation>
            <numerusform>Colour %n character</numerusform>
            <numerusform>Colour %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n character(s)</source>
        <translation>
            <numerusform>Turn %n character</numerusform>
            <numerusform>Turn %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Animate %n character(s)</source>
        <translation>
            <numerusform>Animate %n character</numerusform>
            <numerusform>Animate %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Set the walk of %n character(s)</source>
        <translation>
            <numerusform>Set the walk of %n character</numerusform>
            <numerusform>Set the walk of %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Set how %n character(s) walk</source>
        <translation>
            <numerusform>Set how %n character walks</numerusform>
            <numerusform>Set how %n characters walk</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tag %n character(s)</source>
        <translation>
            <numerusform>Tag %n character</numerusform>
            <numerusform>Tag %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Untag %n character(s)</source>
        <translation>
            <numerusform>Untag %n character</numerusform>
            <numerusform>Untag %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Event reached %n character(s)</source>
        <translation>
            <numerusform>Event reached %n character</numerusform>
            <numerusform>Event reached %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n character(s)</source>
        <translation>
            <numerusform>%1: %n character</numerusform>
            <numerusform>%1: %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n character(s)</source>
        <translation>
            <numerusform>Move %n character</numerusform>
            <numerusform>Move %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing runs that could hear an event: give the scene rules, or characters a path, and press Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Scale %n character(s)</source>
        <translation>
            <numerusform>Scale %n character</numerusform>
            <numerusform>Scale %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this size</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Give %n character(s) another material</source>
        <translation>
            <numerusform>Give %n character another material</numerusform>
            <numerusform>Give %n characters another material</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this material</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Take %n character(s) into a group</source>
        <translation>
            <numerusform>Take %n character into a group</numerusform>
            <numerusform>Take %n characters into a group</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are in this group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mask of the brush leaves all of them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The group is locked or hidden: the Groups panel shows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Restore %n character(s)</source>
        <translation>
            <numerusform>Restore %n character</numerusform>
            <numerusform>Restore %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Shuffle %n character(s)</source>
        <translation>
            <numerusform>Shuffle %n character</numerusform>
            <numerusform>Shuffle %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them have the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Give %n character(s) another template</source>
        <translation>
            <numerusform>Give %n character another template</numerusform>
            <numerusform>Give %n characters another template</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this template</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Make %n character(s) alike</source>
        <translation>
            <numerusform>Make %n character alike</numerusform>
            <numerusform>Make %n characters alike</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them are like that already</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Change the parts of %n character(s)</source>
        <translation>
            <numerusform>Change the parts of %n character</numerusform>
            <numerusform>Change the parts of %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are like that</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Push %n character(s)</source>
        <translation>
            <numerusform>Push %n character</numerusform>
            <numerusform>Push %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no room to push them</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Smooth %n character(s)</source>
        <translation>
            <numerusform>Smooth %n character</numerusform>
            <numerusform>Smooth %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them are like their neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Set the time of %n character(s)</source>
        <translation>
            <numerusform>Set the time of %n character</numerusform>
            <numerusform>Set the time of %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already begin then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+click somebody to choose first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has the chosen part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them sit: who sits keeps the seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has the chosen material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody gets there on foot: raise “Highest step” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too steep to walk: raise “Steepest slope” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too low to walk under: lower “Body height” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too near to a wall or an edge: lower “Body radius” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a state in the brush&apos;s settings first</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Paint a feature of %n character(s)</source>
        <translation>
            <numerusform>Paint a feature of %n character</numerusform>
            <numerusform>Paint a feature of %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Dress %n character(s)</source>
        <translation>
            <numerusform>Dress %n character</numerusform>
            <numerusform>Dress %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are dressed like that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no such feature: choose another kind or value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no relation of that name: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag on to whom they are related</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them has such a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those are too many relations at once: take fewer characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now draw around those to whom they are related (Esc: no)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Change relations of %n character(s)</source>
        <translation>
            <numerusform>Change relations of %n character</numerusform>
            <numerusform>Change relations of %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Their relations are like that already</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Retake %n character(s)</source>
        <translation>
            <numerusform>Retake %n character</numerusform>
            <numerusform>Retake %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>No take is shown: keep what was played, then choose it in the Takes panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another take is still being made: wait for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An obstacle or forbidden ground: choose “Anywhere” in the brush settings to create there all the same</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ClipRole</name>
    <message>
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the character does while it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it gets on at its usual speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it gets on when it is in a hurry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it gets on without touching the ground, at the clip&apos;s own pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does on a seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Played only where a brush or a rule asks for it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Cues</name>
    <message>
        <source>Nobody is selected who could hear “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cue: “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Play first: cues speak to characters while it plays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where characters can walk is still being found: they hear cues from when they begin to move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The state that “%1” recalls is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FeatureCommands</name>
    <message>
        <source>It needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is one of that name already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are as many values as there can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrange values</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1”: %n characters changed</source>
        <translation>
            <numerusform>“%1”: %n character changed</numerusform>
            <numerusform>“%1”: %n characters changed</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody bears it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take features from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene has at most %1 features: remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is there yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone; %n characters had it</source>
        <translation>
            <numerusform>“%1” is gone; %n character had it</numerusform>
            <numerusform>“%1” is gone; %n characters had it</numerusform>
        </translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone; %n characters had a value of it</source>
        <translation>
            <numerusform>“%1” is gone; %n character had a value of it</numerusform>
            <numerusform>“%1” is gone; %n characters had a value of it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>“%1” for all, as nobody is selected: %n characters changed</source>
        <translation>
            <numerusform>“%1” for all, as nobody is selected: %n character changed</numerusform>
            <numerusform>“%1” for all, as nobody is selected: %n characters changed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>“%1” changed, and %n characters with it</source>
        <translation>
            <numerusform>“%1” changed, and %n character with it</numerusform>
            <numerusform>“%1” changed, and %n characters with it</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Features</name>
    <message>
        <source>emotion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neutral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>attentive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>happy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>everyday</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>team red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>team blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>antique rich</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>antique poor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outfit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fields</name>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All in the circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> /s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also characters hidden behind others or the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each dab changes again whom it touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen: size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The harder the pen presses, the larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen: rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The harder the pen presses, the more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often low (left) to high values (right) come: draw it; a double click makes all equal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips (none: as they are)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also what lies between the colours, not only one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each slot its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another colour for each slot of a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only on free seats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat grid: characters sit down where they may</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows counted from the front, as 1, 3-5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wedges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wedges of seats, as 1, 3-5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the seats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also on roofs, trees and wherever else nobody can walk to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> /m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Girth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outfits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each wears any of the clothes that the template has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each has any of the skins, faces and hair that the template has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each wears some of the template&apos;s parts, as hats and bags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips (none: what suits)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters under the brush hear the event while it plays. Rules say what they do then; the number can be a walking speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On to the first place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jump to the first place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somewhere to go to; does nothing by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody walks into it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws those who walk near it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those who walk near it keep away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who reaches it leaves the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters walk slower there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forbidden ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody walks there; ways lead around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liked ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ways lead over it where that is not much longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the girth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change how they walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With which clip characters walk. None: what fits the speed. A clip that stays in place is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters walk along it when it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point to face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another material for each slot of a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metres per second; 0: the usual speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The group that new characters come into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the selected characters alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Templates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All but these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on those whom the mask leaves out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk as one party</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them take the same branch of a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours and materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase and speed of their clips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips, colours, materials and parts of the same names stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who they become, by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+click somebody to choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path, speed and way of walking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else it is hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Movement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neighbours within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of those of the same template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within a range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wave along the stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple from the press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All in step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the shortest to the longest delay along the line that is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the wave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What their template has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they were created</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As last saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As before the last brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they were created: those of a file as they were when it was opened. As before the last brush: before the brush was taken up that was used before this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the template: what suits standing or sitting, at the usual speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Materials and parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place and heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last begins after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: all begin at the same moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Like a ring that grows on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who is near in the picture begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row by row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the front seats to the last row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block by block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From one wedge of seats to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips fade into each other, colours and sizes run, while it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a state has of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that it holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values (none: all of them)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often, against the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whatever it is for; who sits plays those to sit with, gaits are walked with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at rest, standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at rest, sitting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of the clip&apos;s name: “cheer” is also “sit_cheer”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of the slot&apos;s name; empty: all that is worn and not named beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else it multiplies the material&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of the part&apos;s name; empty: all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A start of one&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast clips play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast they walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How tall they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How stout they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From A to B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those where the stroke begins to those where it ends; with a rectangle or lasso those of the first one to those of the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each to the one before on the way of the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each to a few of those around, drawn at random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each to each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All whom the stroke touches, with one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much they mean to each other; drawn for each relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relations of this kind go that those under the brush have; Ctrl while painting does the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mutual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else it goes from one to the other alone, as from a leader to a follower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever is related to somebody on whom an emotion or an outfit is painted gets the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When painted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever is related to somebody who is coloured gets the same colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As each likes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who walk the same path keep beside each other where there is room, and wait for each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who has no path of his own follows the one from whom the relation goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who walk give each other a wide berth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who stand near each other turn to each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass events on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An event that one hears the others hear a little later, and so on from one to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the sun stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How high the sun stands over the horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark the shadows are that people and stages cast; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Softness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How large the sun is in the sky: the larger, the softer the edges of shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour of the light that comes from all of the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sky overhead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sky at the horizon, and the ground far away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines a metre apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Afternoon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Night</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spotlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>somebody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It goes with him while it plays. Select somebody and press the button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It goes with the middle of those in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At 100 % it is as bright as the sun ten metres away; nearer it is brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How wide it opens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft Edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of it is seen in the air, as in smoke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aims at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it hangs or stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of what is a hundred metres away the air hides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air and Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each stop doubles the brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour of light that looks white: lower makes the picture bluer, higher warmer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is brighter than white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark it is in corners, under people and where they sit: less of the sky is seen from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the lower to the higher values along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last colour along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last value along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last material along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: they face along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A few of the nearest are related with one another, as families are: two of another look, and smaller ones with them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the slower to the faster along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last template along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People and stages stand in its light. The four strongest lights that are to cast shadows do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They bear none of it any more: what it did to them is as their template has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lies low, up to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The height above the ground at which a third of it is left, as of mist over a square; 0: it is everywhere alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strongly what is smooth, as water, glass, metal and skin, mirrors the sun, the lamps and the sky; 0: not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cartoon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By property</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How surfaces are drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spotlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lights that stand in the scene shine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One colour instead of the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ground around stages is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own Outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines around things, instead of those that the style has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing: a marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name for a moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>call a cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the cue sends, and the state it recalls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recall a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the run alone: the scene stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send an event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules answer it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without one it is called after what happens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When it happens, by the clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That comes along: rules ask for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cut, or a move that takes its time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At once, or as a flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around what it looks at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From its first place to its last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it goes to, or begins with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>360°: once around; less than nothing: the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: at once, a cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks ahead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else at what it looked at before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gently</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It begins and ends slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>later or earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that they do, by some seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slower or faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a while; they are late, or early, from then on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside their way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the right or to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody sees them for a while</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less than nothing: earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 %: as it was; 0 %: they stand still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the right by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less than nothing: to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not after the beginning: to the end of the take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The play range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From now to the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From now for a while</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While a take is shown: those under the brush do this part of it again, by the rules and properties that they have now. Everybody else does what he did, and is avoided. The result is another take.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The play range is set in the timeline; without one it is from now to the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Different each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chance falls otherwise each time. Off: only what has been changed since makes a difference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>somebody else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of another template, doing what they do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of several, each is of one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of Day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts sun or moon, sky and their colours as they are at that hour, paler and softer where there is haze; everything can be changed afterwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around its upright axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without perspective, as in a plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the picture&apos;s lower edge to its upper one. Small: as through a long lens; large: a wide one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture shows from its lower edge to its upper one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the lamp: what is nearer to it than that gets no brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only After Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins as what is seen, and can be set below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sun and sky: those of the scene, ready-made ones, or its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As street lamps: it shines while sun and sky are dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two Tones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light and shade alone, without a step between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A wall, a fence, a kerb: from corner to corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that its corners enclose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each click puts one there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each click adds a corner, a drag draws freely; Enter or a double click ends it, a click on the first corner closes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each click adds a place; Enter, Escape or a double click ends the path, a click on its first place closes it. The next click begins another one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FindWords</name>
    <message>
        <source>people spray add place populate audience</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>erase eraser rubber remove people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color dye clothes tint paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clothes dress costume uniform fans team</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skin hair cloth texture variant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hat bag props accessories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dance clap wave cheer motion pose move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gait speed run stroll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset phase synchronous delay wave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn rotate look face direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size tall small fat thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mood emotion happy sad attribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger message signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go target destination send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>route way road line street parade queue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wall fence barrier obstacle exit entrance door area zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shove spread move comb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>family friends couple pair link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>family team layer flock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undo original back reset former</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mix swap random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blur even average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy stamp duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replace character model exchange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>label mark keyword</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrow pointer choose pick move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters people models stages assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>character model figure glTF GLB Mixamo Blender load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set building scenery model glTF GLB background load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>render export screenshot image PNG EXR still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>render export video film MP4 GIF animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bookmark viewpoint shot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe key flight move shot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy paste clone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back revert mistake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>settings options language memory tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop repeat cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>freeze bake position stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drop floor snap height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>navmesh navigation mesh floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>canvas docks interface hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lamp sun sky night day shadow fog spotlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wall fence obstacle exit entrance door area zone places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>behaviour behavior trigger condition if cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>snapshot pose version mood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe animation marker schedule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording cache simulation bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undo back steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers edit later stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>favourites favorites saved brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selected person inspector properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outliner stages characters files missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters models mix weights people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color palette swatches dropper wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mood emotion attributes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>family friends links network</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers families teams visibility hide lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>script code programming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>style cartoon clay background tone comic</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FlySession</name>
    <message>
        <source>Flying at %1 m/s – W A S D, Q and E, wheel for the speed, click to land, Escape to go back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flying at %1 m/s – W A S D, Q and E, wheel for the speed, release to land, Escape to go back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GroupCommands</name>
    <message>
        <source>New group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected: there is nobody to take in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Take %n character(s) into a group</source>
        <translation>
            <numerusform>Take %n character into a group</numerusform>
            <numerusform>Take %n characters into a group</numerusform>
        </translation>
    </message>
    <message>
        <source>The group is locked or hidden: its characters cannot be selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a group alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HandEdits</name>
    <message>
        <source>%1 s earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 % of the pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from %2 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what was played as a take and show it: then people of it can be edited by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select those who are to be edited.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are as many edits as a take can have. Delete some.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Edit %n character(s) of the take</source>
        <translation>
            <numerusform>Edit %n character of the take</numerusform>
            <numerusform>Edit %n characters of the take</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n character(s): %1.</source>
        <translation>
            <numerusform>%n character: %1.</numerusform>
            <numerusform>%n characters: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Switch an edit on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch an edit off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the take&apos;s edits on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the take&apos;s edits off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete an edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2–%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>somebody else: choose of which template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>somebody else: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Y up (glTF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y down</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>IndividualWriter</name>
    <message>
        <source>Change template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sit down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no seat %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else sits on seat %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the mode of a tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change outfit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>As the System</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <extracomment>the name of this language in this language</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LightCommands</name>
    <message>
        <source>A scene has at most %1 lights: remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a light</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LightHandles</name>
    <message>
        <source>Move a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a cone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LookCommands</name>
    <message>
        <source>A scene has at most %1 looks: remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A look needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a look “%1” already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take looks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Looks</name>
    <message>
        <source>&amp;Plain Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base colours without light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light of the sun and the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cartoon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink lines, and light in three steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cl&amp;ay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes and light alone: everything of one material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Silhouettes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark people on a bright ground, as a crowd is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Blueprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bright lines on blue, as a plan is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges of the triangles that are drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By P&amp;roperty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour for each template, group, mood, density and more, with a legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spotlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Example</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to &amp;Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep View as Ca&amp;mera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Len&amp;gth of a Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Make Path of Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dra&amp;wn As</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Crowd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ways and Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Behaviour and Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values and Scripts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall &amp;State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep State</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>%1 must be a tag from 0 to 63</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must lie between %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be one of: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a whole number that is not negative and not too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be at least %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a colour and its strength, as &quot;#f0962cff&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be true, false or null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of %2 numbers from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must run from the lowest to the highest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has too many entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of whole numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of colours, as &quot;#f0962c&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a colour, as &quot;#f0962c&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of finite numbers or null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of words or null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 names the clip &quot;%2&quot;, which no template of the scene has; there are: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 names the slot &quot;%2&quot;, which no template of the scene has; there are: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>places: &quot;%1&quot; (id %2) is too far away: positions lie from -1000000 to 1000000 metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of ids of places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paths: &quot;%1&quot; (id %2) names the place %3, which is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paths: &quot;%1&quot; (id %2) branches off to the path %3, which is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be 30, 60 or 120</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The environment is nested more than %1 deep.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The environment has no &quot;%1&quot;: there are %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the id %2 is not allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the id %2 is given twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no &quot;%2&quot;: there are %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be three finite numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a unit quaternion [x, y, z, w]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a Crowdbrush scene (there is no &quot;format&quot;: &quot;%1&quot;). Models are brought in with Import, not opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its &quot;version&quot; must be a whole number above zero; restore an older copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was written by a newer Crowdbrush (file version %1, this program reads up to %2). Update Crowdbrush to open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be above zero and at most 4000000000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has more than %2 parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be one of F3 to F10 or empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of pairs: an individual&apos;s id and a number from -1000000 to 1000000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 names the individual %2 twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there are more than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tags: the tag %1 is given twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the %1 failed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: let the name end in one of %2; it says what the picture is written as.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the picture could not be made: %2. Try a smaller size, or another ending.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Check the folder, its rights and the space on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The script was not saved; choose another place or free some room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standing still, since their paths cannot be walked: %1. Give them another path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path &quot;%1&quot; names a place that is not there any more; characters pass it over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place &quot;%1&quot; has no position or size; characters pass it over. Give it numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path &quot;%1&quot; has no places: nobody can walk it. Add some.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; repeats without any time passing: let it wait or play a clip. It was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; changes a number that is not there any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters appear at a place that is not there any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters follow a path that is not there any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters leave at &quot;%2&quot;, but some do not get there: they stay. Move it, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends more events than can be under way; further ones are dropped. It may be sending events that make it send again: give it a pause, or say how often at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters sit down, but the scene has no seats. Bring a stage with seats along.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; names a place that is not there any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to a place that is not there any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to places of a path that is not there any more, or has none. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to places by a name that none has any more. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters leave at an exit, but there is none: they stay. Paint one with the environment brush.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to a place, but there is none. Paint one with the path brush.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; follows whoever sent the event, but it came from a brush, a cue or nobody. Let characters send it, or follow those with a tag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; fires over and over for the same characters: events go round in a circle. Give it a pause, or say how often at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is more for rules to do at once than a step has room for; characters act later, and events beyond half a million are dropped. Let rules send events to fewer characters, wait in between, or come less often.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path &quot;%1&quot;: between &quot;%2&quot; and &quot;%3&quot; no way leads; characters go as near as they can. Move one of them, or lead the path around what is between.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path &quot;%1&quot;: between &quot;%2&quot; and &quot;%3&quot; something is in the way; characters go around it. Add places where they should go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place &quot;%1&quot; is not on ground that characters can walk on; they go as near as they can. Move it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 character who should walk stand where no way leads to or from: on roofs or trees, in a basin, in the air. Put them on the nearest ground (Edit, Put on the Ground).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 characters who should walk stand where no way leads to or from: on roofs or trees, in a basin, in the air. Put them on the nearest ground (Edit, Put on the Ground).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There cannot be %1 steps a second; there are as many as usual. Choose a length in the menu Play.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walkers that are not in the scene, or named twice. Left out: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event &quot;%1&quot; came with a number that is none, and is not sent. Give it another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters without a position, left out: %1. Delete them, or give them one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no stage to walk on; characters walk on open ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The walkable surface was not built: it was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of the stage can be walked on; characters walk on open ground. Check its size, which way is up, and how wide, tall and steep characters can walk (Environment panel).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no workload &quot;%1&quot;: choose square, corridor, city or paths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2; it must lie from %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is none of the choices there are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs from the lowest to the highest value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be in ascending order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must hold at least one colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temporary file holds something else than an undo step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no temporary file could be made (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk of the temporary file is nearly full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temporary file could not be written (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temporary file could not be read (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temporary file is shorter than it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temporary file does not hold what was written to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no process to unpack it in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes too long to unpack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it unpacks to more than it says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 animation keys are out of order or no numbers; they are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is longer than an hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the times of its keys are not single numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the animations have more than %2 numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: it has %2 values of the wrong number or type for its %3 keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not the index of one of the file&apos;s %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, but the file has only %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a list of indices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, not a whole number from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no multiple of 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is none that glTF 2.0 knows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has more than %2 numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lacks its indices or values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not an unsigned type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing or empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not one of the file&apos;s %2 variants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a list of one 4x4 matrix a joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not one of the animation&apos;s %2 samplers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 names a scene, but the file has none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a child of both %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is its own ancestor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file ends within the GLB header (%1 bytes)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the GLB header says version %1; only glTF 2.0 can be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the GLB header promises %1 bytes, the file has only %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes after the end of the GLB are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is %3 bytes long, but only %4 are left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is not the JSON chunk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is a second JSON chunk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Wavefront OBJ file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Collada file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a USD file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an Alembic file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an STL file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PLY file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a BVH motion file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an X3D file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a 3DS file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a VRM file of an unknown kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the data: URI has no comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the data: URI is not valid base64</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a plain file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is larger than 1 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be opened: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be read to its end: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is %1, which Crowdbrush does not read. Convert it in Blender: %2, then File &gt; Export &gt; glTF 2.0 (.glb)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is neither a .glb (it does not begin with &quot;glTF&quot;) nor a .gltf (it does not begin with &quot;{&quot;)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a path that begins at the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 vertices, but its accessors say %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 indices, but its accessor says %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it lacks an attribute that the file wants of it, or has it with another number of components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no POSITION</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is nothing that a mesh has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the compressed mesh cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program %1, which belongs beside crowdbrush, is not there; export the file without Draco compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.uri: %2; put that file there, or export the file as .glb, which holds all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.uri: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no uri, and the file has no binary chunk for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 should have %2 bytes, but only %3 are there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the buffers are larger than 1 GiB together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it hides is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. Check the name, the folder and its rights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. Export it again as glTF 2.0 (.glb) from the program it was made in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs more memory than there is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a picture that can be read (PNG, JPEG and WebP can)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be decoded: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is too large (%1 x %2 pixels)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no PNG, JPEG or WebP picture and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has neither uri nor bufferView</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pictures are larger than 512 MiB together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is left out: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing %1 was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no mesh, so that nobody made of it could be seen; export the file again together with the character&apos;s mesh, as triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its scene has no triangles, so that nobody made of it could be seen; export the file again together with the character&apos;s mesh, as triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be imported: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has another type or count than its fellows need</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: more than %2 instances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the JSON is nested more than %1 levels deep at byte %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the JSON has more than %1 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the JSON is not an object, so this is no glTF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the JSON cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 levels of detail; the finest %2 are used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 slots; only the first %2 can be tinted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slot &quot;%1&quot;, variant &quot;%2&quot;: its picture lies by another set of coordinates than the default&apos;s, which is used for both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: extras.tintMask is %2, which is no texture of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: its emissive picture lies by another set of coordinates than its base colour, and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: its nodes draw %2 primitives, more than %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: more than %2 of them move meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the morph targets have more than %2 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the scene has more than %2 vertices or %3 triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the first %1 parts can be hidden; &quot;%2&quot; and those after it are always shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file draws nothing: its scene has no triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 primitives are points or lines or have no positions; they are not drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Morph targets are not animated: the mesh keeps its resting shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: it asks for the mode &quot;%2&quot;, which Crowdbrush cannot read; export the file without compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: it asks for the filter &quot;%2&quot;, which Crowdbrush cannot read; export the file without compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not describe data of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the file is larger than 1 GiB when it is unpacked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: its compressed data is damaged, or newer than Crowdbrush; export the file without compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>KHR_animation_pointer moves nodes alone; what else it animates stands still (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The animation %1 moves nothing that Crowdbrush can move, and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has the wrong type of accessor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2 elements, but POSITION has %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2 values that are no numbers; they are read as 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not fit POSITION</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: vertex %2 follows joint %3, but the skin has only %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: index %2 at position %3, but there are only %4 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends with %2 corners that make no triangle; they are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 seats of the extras cannot be read and are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing, so this is no glTF 2.0 file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 asks for glTF %2; only glTF 2.0 can be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 demands the extension %2, which Crowdbrush cannot read; export the file without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 are more than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reaches to byte %2, but %3 has only %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is %1 m large as it is; import it at scale %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It seems to lie on its back: Z was up where it was made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It seems to face another way than +Z; turn it by %1 degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its lowest point is %1 m from the ground; offset it by %2 m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the folder could not be made; unsaved work is not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be copied (%2). Make room there or choose another place, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene was not saved. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The scene was not saved; choose another place or free some room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is not a file; choose a .crowd file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be opened (%2). Check its name and that you may read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is larger than 1 GiB, too large for a scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be read to its end (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of three finite numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is damaged or was edited wrongly: %1. Correct this place in a text editor, or restore an older copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>binary data is not allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it ends too early, at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a number that is too large at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not valid JSON at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not valid JSON at %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands twice in the same object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file must hold a JSON object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a single value of the right kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds more than %1 individuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds more than %1 values beside the individuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>individuals.rows stands there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>individuals.columns must be a list of names and stand before the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;individuals&quot; with &quot;columns&quot; and &quot;rows&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It needs more memory than there is; close other programs and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Individual %1 has a %2 that is not a number; undo the last change or give it a new value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Individual %1 uses the template %2, which the scene does not have; undo the last change, or give the individual another template.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a value that cannot be saved: %1. Undo the last change or give it a new value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number that is not negative and not too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tint like &quot;#c04020ff&quot; (red, green, blue, strength)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sixteen hexadecimal digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Individual %1 had the same seat as individual %2 and has none now; move one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more shared a seat and have none now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 individual has a %2 outside %3 to %4; it is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 individuals have a %2 outside %3 to %4; it is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 individuals followed a path that the file does not list; they follow none now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number above zero and at most 4000000000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two individuals have the id %1; give one of them another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>individual %1 uses the template %2, which the file does not list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip &quot;%1&quot; is not in the file any more; &quot;%2&quot; is played instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the built-in models were not found. Install them beside the program or name their folder in CROWDBRUSH_RESOURCES.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there is no such built-in model. Locate a file instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a folder, not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a pipe, not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a device, not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver offers no framebuffer of %1 by %2 pixels. Try a smaller picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver does not compile the shader %1 (%2): %3 A newer driver, or LIBGL_ALWAYS_SOFTWARE=1, may help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver does not link the shader %1 (%2): %3 A newer driver, or LIBGL_ALWAYS_SOFTWARE=1, may help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures without a window need EGL with device or surfaceless displays, and this system&apos;s libEGL has neither. Install Mesa (packages libegl1 and libgl1-mesa-dri).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of this system&apos;s %1 EGL displays gives a context for OpenGL 3.3. Install a newer graphics driver, or Mesa&apos;s software one (package libgl1-mesa-dri).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of this system&apos;s %1 EGL displays gives a context for OpenGL with display lists. Install a newer graphics driver, or Mesa&apos;s software one (package libgl1-mesa-dri).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing needs OpenGL 3.3; this context offers %1. Install a newer graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The environment must be an object with lists of places, paths, groups, tags, rules, numbers and cues.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was written by a newer version; update to use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There already is a preset %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be removed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something else is being edited: finish or cancel (Esc) it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a %2 file cannot be transparent. Let the name end in .png, or switch the transparency off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no brush preset. Choose a file that was saved as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no name. Write one into the file, as its member &quot;name&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;version&quot; must be %2. Copy the file again from where it came.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is damaged: in line %2 it is no JSON any more. Copy the file again from where it came.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place &quot;%1&quot;: %2 characters want to stand there; there is room for %3. Make it larger, or send them to several places.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 of %2, column &quot;%3&quot;: it must be %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 of %2 must have %3 values, one for each column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.rows stands there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.ids must be ascending numbers like &quot;1-7,9&quot; and stand before the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.columns must be a list of names and stand before the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must have as many rows as ids: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.columns must be a list of names that begins with &quot;id&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.columns names &quot;%2&quot; twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.columns lacks &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 of them the template is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 of them the path is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 of them the seat is taken: they stay where they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 of them there is no clip &quot;%2&quot;: they keep theirs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the state is not there. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the value of a feature is not there. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no features. Choose a file that was saved from the panel Features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are as many values of features as there can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene has at most %1 features. Remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a kind or a value has no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; is given twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the id of an individual, a whole number above zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the id of a kind of relation, from 1 to 64</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relations.columns must stand before the rows, once, and be %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 relations are left out: they are of individuals or kinds that the scene has not, or of somebody to himself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 relations stood there twice: the last ones count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds more than %1 relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a kind has no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be an object with columns and rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the light is not there. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People cannot be coloured by “%1”. There are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An orthographic camera has no lens: everything is sharp. Take a camera with perspective, or leave out depth of field.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance of focus must be from 0.01 to 1000000 metres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The f-stop must be from 0.01 to 1000; the smaller, the less is sharp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no looks. Choose a file that was saved from the panel Looks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene has at most %1 looks: remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is that of another look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a scene has at most %2 looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no look &quot;%1&quot;; there are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours by &quot;%1&quot; are of the look &quot;property&quot;, not of &quot;%2&quot;: leave one of the two out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: its normal map lies by another set of coordinates than its base colour, and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: let the name end in one of %2; it says what the movie is written as.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no file: give the movie another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: movies are made by ffmpeg, which cannot be started (%2). Install the package ffmpeg, or write single pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the movie could not be made, ffmpeg has ended: %2. Check the space on the disk, or choose another kind of file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The movie was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was played at %1 s is not known any more. Play it again, or begin the movie later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline recalls a state that is not there. Choose another one for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline calls the cue “%2”, which speaks to the selected: the mark names nobody. Let the cue reach everybody, or a tag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline calls a cue that is not there. Choose another one for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline speaks to characters of whom none is there any more. Remove that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline sends an event without a name. Choose one for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no pass &quot;%1&quot;. There are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver offers no framebuffer of numbers of %1 by %2 pixels. Try a smaller picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 by %2 pixels are too many for passes, whose numbers take much memory: at most 40 million. Choose a smaller size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline wants the camera “%2”, which is not there. Choose another one for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the camera is to travel along a path: choose one of at least two places for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the camera goes nowhere: choose a camera for that mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a movie cannot be transparent. Choose numbered pictures, or switch the transparency off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 seconds the timeline moves the camera twice: only the later mark is seen. Move one of them, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; cannot be read at %2 s: its file is damaged. Fetch it from a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take cannot be read: its file is damaged. Fetch it from a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take is too short to take a part of it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is chosen who could be taken again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stretch of time has a beginning and an end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stretch that is to be taken again lies outside the take, or is empty. Choose another one on the timeline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The take was not kept; free some room or save the project elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is damaged or no take. Keep the take once more, or fetch the file from a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been played yet: there is no take to keep. Play first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder could not be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is of a newer version of Crowdbrush, or of another kind of machine. Open it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion of the take &quot;%1&quot; is missing: put its file %2 into the folder %3, or delete the take.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The take &quot;%3&quot; would be lost; choose another place or free some room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are more takes than %1: the others are not opened. Delete some, save and open the project again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is not a file; choose a .take file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is cut off. Keep the take once more, or fetch the file from a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; has %2 edits by hand; there can be %3. Delete some.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is done to people by hand is a list of objects.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A take has at most %1 edits by hand, not %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The takes &quot;%1&quot; and &quot;%2&quot; have no time in common.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no room for passes: let the name end in .exr or .png.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: only OpenEXR has room for the pass &quot;%2&quot;. Let the name end in .exr, or leave that pass away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a picture has at most %2 pixels a side, not %3. Choose a smaller size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a %2 file has at most %3 pixels a side, not %4. Let the name end in .png, or choose a smaller size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a quaternion (w, x, y, z) of length 1; (1, 0, 0, 0) does not turn. The length of what was given is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is built like a person and %1 m tall; import it at scale %2, or at 1 if it is a giant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is named &quot;%1&quot; and %2 m large; import it at scale %3, or at 1 if it is meant to be so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is named &quot;%1&quot; and %2 m large: scale %3 would make it as large as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a list of [x, y, z], metres from the position: 2 or more of a line, 3 or more of an area, at most %2, none farther off than %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory of the graphics card does not suffice for this picture, however coarse. Choose a smaller picture, remove templates from the scene, or close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NavigateTool</name>
    <message>
        <source>Drag: orbit · Shift: pan · Ctrl: nearer, farther · Wheel: towards the cursor · Right button or Shift+F: fly with WASD · F: show the selection</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Paths</name>
    <message>
        <source>Path %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PicturePasses</name>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Individual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cryptomatte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlaceCorners</name>
    <message>
        <source>Move a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A line keeps two corners, an area three.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a corner</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlaceHandles</name>
    <message>
        <source>Resize a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Move %n place(s)</source>
        <translation>
            <numerusform>Move %n place</numerusform>
            <numerusform>Move %n places</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select two places or more first, in the order to walk them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: characters stop at its last place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: characters go round and round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: characters jump from its last place to its first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back a path of one place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back a single corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two corners make a line: an area has three or more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlaceTool</name>
    <message>
        <source>Lead a path over a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a place to a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: put it on the ground · + −: its size · V: move and resize</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path is closed: characters go round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to walk on there: the pointer is on the sky, or on something upright. Click on the ground beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No way leads there from the place before: characters go as near as they can.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is in between: characters walk %1 m around it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: add a corner · Drag: draw freely · Enter, Esc or double click: end it · on the first corner: close it · V: move corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: add a corner · Drag: draw freely · Enter, Esc or double click: end it · on the first corner: close it · + −: the width of a line · V: move corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: add a place to the path · + −: its size · on the first place: close the path · Enter or Esc: end it · Double click on a path: another place in it · V: move and resize places</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QuickCard</name>
    <message>
        <source>Brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whom the cursor points at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>some in the circle, a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all whom the circle passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all in a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all inside a drawn line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same value for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn for each of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from one end of the line to the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crowdbrush at a glance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Editing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReadyNames</name>
    <message>
        <source>Above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audience</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beetles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye to eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fountain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the bridge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the top row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floodlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Landing pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picnic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Street lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cheering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disappointed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>City</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stadium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theatre</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RelationCommands</name>
    <message>
        <source>A scene has at most %1 relations: remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is one of that name already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes two: select whom to relate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those are too many: select at most %1 characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Relate %n character(s)</source>
        <translation>
            <numerusform>Relate %n character</numerusform>
            <numerusform>Relate %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>None of the selected has such a relation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take relations away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has such a relation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected: there is nobody to duplicate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n character(s)</source>
        <translation>
            <numerusform>Duplicate %n character</numerusform>
            <numerusform>Duplicate %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Relation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone, and %n relations of that kind with it</source>
        <translation>
            <numerusform>“%1” is gone, and %n relation of that kind with it</numerusform>
            <numerusform>“%1” is gone, and %n relations of that kind with it</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody else is related so to the selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n more are selected now</source>
        <translation>
            <numerusform>%n more is selected now</numerusform>
            <numerusform>%n more are selected now</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No seat is free near %n of them: they stand</source>
        <translation>
            <numerusform>No seat is free near %n of them: it stands</numerusform>
            <numerusform>No seat is free near %n of them: they stand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Relations</name>
    <message>
        <source>family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>friends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>couple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leader</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rivals</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleLog</name>
    <message>
        <source>%1–%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s · %2 · %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times</source>
        <translation>
            <numerusform>%1 · once</numerusform>
            <numerusform>%1 · %n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times each</source>
        <translation>
            <numerusform>%1 · once each</numerusform>
            <numerusform>%1 · %n times each</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times in all</source>
        <translation>
            <numerusform>%1 · once in all</numerusform>
            <numerusform>%1 · %n times in all</numerusform>
        </translation>
    </message>
    <message>
        <source>character %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>characters %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a deleted rule</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleSets</name>
    <message>
        <source>%1, seated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wave runs on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run at the number&apos;s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop until told to walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some stop and look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flee, tell others, leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wander about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run from what startles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applause spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cheers spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Be served, then leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All calm down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waving spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sadness spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boredom spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anger spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cheers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Startle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line up</source>
        <comment>cue</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RuleTextsConte</name>
    <message>
        <source>(gone)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Rules</name>
    <message>
        <source>choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(gone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose clips…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When it begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone’s clip is over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>their group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>everybody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walk on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the event’s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The place is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has a clip to play: choose one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an event comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>someone arrives at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>someone enters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>someone leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a path ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a clip is over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every so often</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>someone tagged is near</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tagged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walking path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play a clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walk along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send an event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>those near</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>those tagged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interrupts what they do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waits until they are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only who is free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Audience Reactions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stadium Wave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pedestrians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panic and Exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flock of Animals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, then </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A condition asks for something that is not there: choose again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: add something to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sit on the nearest free seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stand up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number is not there: make one below, under “Tags and numbers”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed is passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>someone has stood for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>own number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>event’s number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sit on a free seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait for an event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add to a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>appear at a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yields to rules further up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yields to any rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yields to no rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest free one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first free one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the one ahead, when free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Queue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often it comes, against the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all that can be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour; how much of it beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the place ahead gets free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>property</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to someone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow someone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change a property</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>girth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>playback speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walking speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clip while at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place in that clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whoever it came from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to repeat: press “+ in it”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is only one to choose: press “+ or…” for another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of them ever comes: let one come more often.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A place is nobody to go after: choose whom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has a slot of that name: choose one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the place ahead of someone gets free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>either %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>full: the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>happens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not happen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of characters in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the selected characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: type the event that it waits for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: type the event to send.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: type the event to wait for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a number; make one below, under “Tags and numbers”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a template.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It never comes: its conditions exclude each other. Remove one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It never comes: “%1” above it comes at the same occasion. Let this one wait until they are free, or give one of them a condition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It gets nothing done: “%1” breaks it off at once. Let one of them wait until they are free, or give it a condition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It undoes what “%1” does at the same occasion. Give one of them a condition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no seats to sit on: bring a stage with seats along.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no exit to leave at, so characters stay: paint one with the environment brush (I).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest free exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the first free exit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add {value} to {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>appear at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {metres} m away from the nearest one tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {metres} m away from {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How near they come</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow whoever it came from for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow whoever it came from until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow the nearest one tagged {tag} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow the nearest one tagged {tag} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow {place} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow {place} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walk along {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>however long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to whoever it came from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest one tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of any path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with any name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest free place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest free place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest free place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the first free place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the first free place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the first free place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move up to the next free place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move up to the next free place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move up to the next free place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of all exits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest free place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the nearest free place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the first free place of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the scene at the first free place named {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the nearest free one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the first free one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at whoever it came from for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at whoever it came from until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at the nearest one tagged {tag} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at the nearest one tagged {tag} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at {place} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at {place} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{inside}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play {clips}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untag {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for ever</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat for ever {inside}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat {times} × {inside}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever is nearer hears it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long it takes from one to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>once for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules that hear it can ask for it, or walk as fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to those within {metres} m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to those tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to their group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to everybody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set {number} to {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn {color}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn {color} at {slot}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>become {value} × as tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move {value} × as fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from now on {clips}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to {value} of their clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at {value} m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>however far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sit on the nearest free seat within {metres} m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn to whoever it came from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn to the nearest one tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn to {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait about {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait for “{event}”, at most {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait for “{event}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> % of cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by chance in {chance} % of cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>except by chance in {chance} % of cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walking {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not walking {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not tagged {tag}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place} full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place} not full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not seated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number} not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a {template}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a {template}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characters in {place} not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>showing {clip}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not showing {clip}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{property} not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the place ahead of someone in {path} gets free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone arrives at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone enters {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When “{event}” reaches someone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone leaves {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone reaches the end of {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone gets faster than {metresPerSecond} m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone gets slower than {metresPerSecond} m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slower than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faster than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone tagged {tag} comes within {metres} m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone has stood for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play {clips} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yields to others further up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take on a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beginning within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take on “{state}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take on “{state}” within {within} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take on “{state}” over {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a state is recalled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone takes on a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone takes on “{state}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The state is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a state; the panel States keeps one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take on a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>become “{feature}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{feature}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not “{feature}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a feature changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When a feature of someone changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When someone becomes “{feature}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The feature is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {metres} m away from the nearest of their {relation}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow the nearest of their {relation} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follow the nearest of their {relation} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the nearest of their {relation}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at the nearest of their {relation} for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at the nearest of their {relation} until something else comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send “{event}” to their {relation}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn to the nearest of their {relation}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of those related</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} not below {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} not at {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of their {relation} not above {value}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrives at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hears</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one related does something</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When one of someone’s {relation} arrives at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When one of someone’s {relation} leaves {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When one of someone’s {relation} hears “{event}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The relation is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all of their</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relations of any kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest of their</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep from side to side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tell a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the light “{light}” on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the light “{light}” on over {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the light “{light}” off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the light “{light}” off over {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let the light “{light}” flash for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let the light “{light}” sweep for {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light is not there any more: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does nothing yet: choose a light; the panel Light adds one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new tag, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is about whoever it came from, but it comes from nobody: let it begin with an event or with someone near, or choose whom it is about.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It asks for an event’s number, but comes without one: let it begin with an event, or give the number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands below “do it again” is never done: move it up, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>purple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {metres} m away from whoever it came from, or anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walks along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a choice of a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is inside a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a place is full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is seated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>their own number is…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is of a template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the event’s number is…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of characters in a place is…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of their properties is…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of those related is…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>their speed is…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>Add template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put characters on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrange states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relate characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take relations away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add rules</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Click: select · Drag: area, or move who is selected · Shift: add to the selection · Ctrl: in or out of it · Double click: puts a place into a path, a corner into a line or takes it out · L: lasso or rectangle · Delete: remove · F: show the selection</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SelectionCommands</name>
    <message>
        <source>Nobody is selected: there is nobody to delete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Delete %n place(s)</source>
        <translation>
            <numerusform>Delete %n place</numerusform>
            <numerusform>Delete %n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n character(s)</source>
        <translation>
            <numerusform>Delete %n character</numerusform>
            <numerusform>Delete %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Put %n character(s) on the ground</source>
        <translation>
            <numerusform>Put %n character on the ground</numerusform>
            <numerusform>Put %n characters on the ground</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters put on the ground</source>
        <translation>
            <numerusform>%n character put on the ground</numerusform>
            <numerusform>%n characters put on the ground</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them stand where characters can walk.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShapeDrag</name>
    <message>
        <source>Add a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to stand on there: the pointer is on the sky, or on something upright. Click on the ground beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is too far away or has more than %1 corners: press Enter, and begin another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShownTake</name>
    <message>
        <source>The take &quot;%1&quot; is shown, and people move as they did in it. To tell them something, take it from here (menu Play), or show the scene as it plays (panel Takes).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StateCommands</name>
    <message>
        <source>“%1”: all of them are like that already</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” recalled: %n characters changed</source>
        <translation>
            <numerusform>“%1” recalled: one character changed</numerusform>
            <numerusform>“%1” recalled: %n characters changed</numerusform>
        </translation>
    </message>
    <message>
        <source>State %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick what the state is to hold first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected whose state could be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is there yet whose state could be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” keeps how %n characters are now</source>
        <translation>
            <numerusform>“%1” keeps how one character is now</numerusform>
            <numerusform>“%1” keeps how %n characters are now</numerusform>
        </translation>
    </message>
    <message>
        <source>Recall “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A state needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a state “%1” already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: none of its characters is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” for %n characters, in this run alone: Stop gives the scene back</source>
        <translation>
            <numerusform>“%1” for %n character, in this run alone: Stop gives the scene back</numerusform>
            <numerusform>“%1” for %n characters, in this run alone: Stop gives the scene back</numerusform>
        </translation>
    </message>
    <message>
        <source>Wait until it is known where characters can walk, then recall the state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is in the group whose state could be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A state holds at least one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change what a state holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep “%1” anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: none of its characters is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected for whom “%1” could be recalled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” recalled in the run; the scene itself was like that already</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatureNote</name>
    <message>
        <source>%1 m tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 m tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from %2 m
%3 to %4 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StepMenu</name>
    <message>
        <source>Change the length of a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of 1/%1 s from the next Play on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/%1 s, as Usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/%1 s, Finer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TakeCommands</name>
    <message>
        <source>Another take is still being kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been played yet: press Play first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what was played as a take and show it: then the selected characters can be taken again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select those who are to be taken again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene as it plays. Press Play to run it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no takes yet: play, then keep what was played.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody walks or follows rules here: there is nothing to keep yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a Marker Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Call a Cue Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>States</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall a State Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send an Event Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select characters: when which rules fired for them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click in a lane: what is to happen then. Or record: cues that are pressed, states that are recalled and events that are painted while it plays come here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from Here On as Now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimelineCommands</name>
    <message>
        <source>The scene has no cues yet: the panel Rules makes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no states yet: the panel States keeps them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A timeline has at most %1 marks: remove some first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked at %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no mark after this moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no mark before this moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has been played up to %1 s: play on to see more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the play range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around, from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1 s on the camera looks as now: “%2”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Navigate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untag Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Script Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking Style Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shuffle Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clone Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emotion Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outfit Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retake Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size Brush</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>There is no camera “%1” in this scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add camera “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update camera “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove camera “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename camera “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look of camera “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::AssetController</name>
    <message>
        <source>glTF models (*.glb *.gltf);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use “%1” as a template to paint with, or as the stage?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The template could not be imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is ready: the create brush paints it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stage could not be imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locate “%1” (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n asset(s) found.</source>
        <translation>
            <numerusform>One asset found.</numerusform>
            <numerusform>%n assets found.</numerusform>
        </translation>
    </message>
    <message>
        <source>Import template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locate assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Templates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the library…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The built-in characters were not found. Install them beside the program or name their folder in CROWDBRUSH_RESOURCES.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Add %n template(s)</source>
        <translation>
            <numerusform>Add %n template</numerusform>
            <numerusform>Add %n templates</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n template(s) ready: the create brush paints them.</source>
        <translation>
            <numerusform>One template is ready: the create brush paints it.</numerusform>
            <numerusform>%n templates are ready: the create brush paints them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters are of this template; delete them first.</source>
        <translation>
            <numerusform>%n character is of this template; delete that one first.</numerusform>
            <numerusform>%n characters are of this template; delete them first.</numerusform>
        </translation>
    </message>
    <message>
        <source>Change clips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 (%2 of %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The same for the %n other file(s)</source>
        <translation>
            <numerusform>The same for the other file</numerusform>
            <numerusform>The same for the %n other files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::app::Autosaver</name>
    <message>
        <source>Unsaved work is not kept for the case of a crash. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::CameraBookmarks</name>
    <message>
        <source>The scene has no camera %1. %2 keeps this view as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1, “%2”, shows this view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Camera</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::ConsoleDock</name>
    <message>
        <source>Python Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open scene is &quot;scene&quot;, everything else is in &quot;crowdbrush&quot;. Return runs, Shift+Return starts another line, Tab completes, up and down go through what was typed before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a script file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the script that runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear what was printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python scripts (*.py)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another script is running: wait for it or stop it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The script that runs does not stop. Close all the same? What it was doing is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… %1 characters are left out …
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record what is done by hand as a script</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::ConsoleInput</name>
    <message>
        <source>Python, for example:  len(scene)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::DialogTask</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::FileController</name>
    <message>
        <source>Crowdbrush scenes (*.crowd)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing a new scene…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene could not be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Scene As</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene could not be saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The assets could not be collected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collect Assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has unsaved changes. Save them?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another scene is being opened; wait for it or cancel it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish or cancel (Esc) what you are doing first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not there any more. It was moved, renamed or deleted; choose File &gt; Open to look for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crowdbrush kept unsaved changes of “%1” from %2. Recover them?

Thrown away, they are gone and the scene opens as it was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Throw Away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crowdbrush kept a scene that was never saved, from %1. Recover it?

Thrown away, it is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed on Disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here. Saving replaces that version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replace It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To keep both, cancel and choose File &gt; Save As.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” exists already. Replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These files are missing and could not be collected:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collect assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Scene As: Its Files Are Collected Beside It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Not Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>It has %n character(s).</source>
        <translation>
            <numerusform>It has %n character.</numerusform>
            <numerusform>It has %n characters.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Stage: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::Interpreter</name>
    <message>
        <source>Finish or cancel the stroke first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::KeysDialog</name>
    <message>
        <source>Left button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opens the brushes at the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes to the point under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Escape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Painting with a brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paints in a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paints in a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paints; Escape takes the stroke back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2, Ctrl + wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smaller and larger brush; dragging with Shift does it too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the brush’s main number: how many, how strong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selecting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, or drag a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selects; Shift adds, Ctrl changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag somebody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves those who are selected, to free seats or the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selects nobody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orbits; with Shift it pans, with Ctrl it comes nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space or Alt held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left orbits, middle pans, right comes nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>show those who are selected; show everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 to 9, Ctrl + 1 to 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to a camera; keep this view as that camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the front, the side, above; also with Alt and the digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>perspective or orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flies: W A S D, Q and E, the wheel for the speed, a click lands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing and the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space tapped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plays and pauses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hides the panels, and brings them back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fills the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preferences change them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paths and behaviour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click with the path brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>adds a place; on the first place: closes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends the path; the next click begins another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a place, or its circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves it, or changes its size (selection)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keeps everybody where they are now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paints one character or place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At a Glance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save to &amp;Print…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>States</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recall a state of the crowd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep it, or who is selected, as that state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages to print (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quick Reference Card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one step on, one back; to the latest moment of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to the start, everybody where the scene has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes on from the moment shown and forgets what came after it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finds actions, brushes, panels and settings by name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::MainWindow</name>
    <message>
        <source>%1[*] – Crowdbrush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scenes yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Crowdbrush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 brings the panels back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Crowdbrush %1&lt;/h3&gt;&lt;p&gt;Paint crowds.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;After “Crowdbrush: Interactive Authoring of Real-time Crowd Scenes” by Branislav Ulicny, Pablo de Heras Ciechomski and Daniel Thalmann, SCA 2004.&lt;/p&gt;&lt;p&gt;MIT licence. Made with Qt %1, GLM, Embree, tinygltf, meshoptimizer and oneTBB.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>× </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of play</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters are kept where they are</source>
        <translation>
            <numerusform>%n character is kept where it is</numerusform>
            <numerusform>%n characters are kept where they are</numerusform>
        </translation>
    </message>
    <message>
        <source>The language changes when what is going on has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown: minutes and seconds from the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This field cannot be changed now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::MovieController</name>
    <message>
        <source>Another movie is still being made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the movie…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The movie could not be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered pictures, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of the pictures are there already.</source>
        <translation>
            <numerusform>One of the pictures is there already.</numerusform>
            <numerusform>%n of the pictures are there already.</numerusform>
        </translation>
    </message>
    <message>
        <source>Draw What Is Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw All Anew</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::MovieDialog</name>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has been played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has been played, with all that was sent, called and recalled meanwhile; or the scene as it plays if nobody touches it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pictures a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n picture</numerusform>
            <numerusform>%n pictures</numerusform>
        </translation>
    </message>
    <message>
        <source>As the timeline moves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once around what the view looks at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For numbered pictures that are put over others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene as it plays by itself</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::PassFields</name>
    <message>
        <source>For compositing: a layer of an OpenEXR file, or a PNG of its own beside that of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For compositing: layers of an OpenEXR file alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureController</name>
    <message>
        <source>Another picture is still being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture could not be saved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureDialog</name>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without sky and ground plane, to be laid over something else. Not as JPEG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is nearer or farther than a distance is soft, as through a lens. Drawing takes longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An orthographic camera has no lens: everything is sharp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the camera turns around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The opening of the lens: the smaller the number, the less is sharp. 1 to 8 as of a camera for photographs, 0.1 as of a model on a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F-stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureSizeFields</name>
    <message>
        <source>As in the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new width gives a new height, and the other way round</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left paints, right opens the brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left a point, middle a circle, right a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose animation finds no room stands still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse buttons of the brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the welcome page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when this page closes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What exceeds it is kept in a temporary file on disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic: smooth while it can keep up, and perfect when nothing moves. Fast spares an old machine; best is always smooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back short strokes in a row together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clicks and dabs that follow each other within a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for prepared animations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n samples a pixel</source>
        <translation>
            <numerusform>%n sample a pixel</numerusform>
            <numerusform>%n samples a pixel</numerusform>
        </translation>
    </message>
    <message>
        <source>While something moves, and as many as the graphics card offers. A picture that rests is always smooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth edges</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::RecordPanel</name>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the whole script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the script, with the scene that it starts from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you do by hand appears here as Python.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
# … %2 more characters of this step are copied and saved …
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Recorded Script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded.py</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python scripts (*.py)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::Recorder</name>
    <message>
        <source>The recording starts anew: this step was done before it began.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording ended: another scene is open now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded as what came of it, not as a stroke: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::ScriptGuard</name>
    <message>
        <source>A script is running: wait for it, or stop it in the console.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::ShortcutsPage</name>
    <message>
        <source>Search for an action or its keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Back to Defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give It to “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a field and press the keys.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::StateKeys</name>
    <message>
        <source>The scene has no state %1. %2 keeps the crowd as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene has no states yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” keeps how they are now; it is number %2 of the states: %3 recalls it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::StatusPanel</name>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n selected</numerusform>
            <numerusform>%n selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n in view</source>
        <translation>
            <numerusform>%n in view</numerusform>
            <numerusform>%n in view</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 ms · %2 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of one picture: %1 triangles in %2 draws</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n have left</source>
        <translation>
            <numerusform>%n has left</numerusform>
            <numerusform>%n have left</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding out where characters can walk…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plays at × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This machine cannot compute what the crowd does as fast as it is to play.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What came after %1 s is played anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too much was edited since it was started: this happens at the latest moment. Stop and play to go back to any moment again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as in &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Played on out of &quot;%1&quot; from %2 s; the take stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The play range of the timeline ends here. A click on its ruler with Shift held: all time is played.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of the graphics card: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::StrokePainter</name>
    <message>
        <source>A script is running: wait for it, or stop it in the console.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stroke was taken back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stopped: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is at work</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::TimeSlider</name>
    <message>
        <source>The run so far: drag to see any moment of it again. What is done to people then happens there, and what came after is played anew.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::app::WelcomeHint</name>
    <message>
        <source>Close, and do not show this again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; over free seats or open ground: characters come. &amp;nbsp;&lt;b&gt;Right click&lt;/b&gt;: the brushes.&lt;br&gt;&lt;b&gt;Space&lt;/b&gt; and drag: look around. &amp;nbsp;&lt;b&gt;Ctrl+Z&lt;/b&gt;: take it back. &amp;nbsp;&lt;b&gt;F1&lt;/b&gt;: all keys.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::model::SceneDocument</name>
    <message>
        <source>Finish or cancel (Esc) what you are doing first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This step cannot be taken: %1. The scene is unharmed; save it. What was done since can still be undone and redone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo takes %1 MB of memory and cannot use the disk: %2. Nothing is lost; make room there, or save and reopen the scene to forget its undo steps.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BranchList</name>
    <message>
        <source>Some leave it:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ branch to another path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no other path yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the weight of a branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many go over for each one who goes on: at 1, half of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a branch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let some characters go over to another path at a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> × as often</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushPaletteDock</name>
    <message>
        <source>Brushes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushPopup</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushSettingsDock</name>
    <message>
        <source>Brush Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Script Brush: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CameraDirector</name>
    <message>
        <source>The view is yours: the timeline does not move it any more. View &gt; Follow the Timeline gives it back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipMix</name>
    <message>
        <source>How often it comes among those ticked</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipTable</name>
    <message>
        <source>Clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (when standing)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the character gets in a second of this clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What characters stand, walk and sit with. Clips of other roles play only where a brush or a rule asks for them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipsDialog</name>
    <message>
        <source>Clips of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ColourDock</name>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour in hexadecimal, as #rrggbb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the colour as a swatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a colour from somebody in the picture (Ctrl and click with the colour brush)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Painted with lately</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A right click removes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another colour for random and for gradients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another colour that new characters may wear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click brings it to the front, from where it paints; a right click removes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New characters wear these:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ColourRow</name>
    <message>
        <source>Add a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: change the colour. Right button: take it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take Out</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CueBar</name>
    <message>
        <source>those tagged %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are %1 cues already, as many as can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ Cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A button, with a key if you like, that lets an event happen to characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is recalled for %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends “%1” to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arrow changes or deletes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (selected)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CueForm</name>
    <message>
        <source>Cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named as its event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The event’s number, a walking speed for example</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recalls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click in the picture where it begins</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::DockBase</name>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentDock</name>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X, Y, Z, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change what a place is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On to the first place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jump to the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the end of a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the room of a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the speed on slow ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No paths yet. Take the path brush (P) and click where characters are to walk; then let characters walk along it with the walk brush (W).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all who fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many have room, for rules that ask whether it is full or free; 0: as many as can stand in it, two on a square metre, but one where characters line up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 &lt;a href=&quot;people&quot;&gt;Select them&lt;/a&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the shape of a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n corner(s), %1 m²</source>
        <translation>
            <numerusform>%n corner, %1 m²</numerusform>
            <numerusform>%n corners, %1 m²</numerusform>
        </translation>
    </message>
    <message>
        <source>Half width, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Margin, m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentMenu</name>
    <message>
        <source>Go On Painting It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete It with Its Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join two paths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the Selected Characters Walk It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select Its Characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a Place After It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take It Out of the Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Delete %n place(s)</source>
        <translation>
            <numerusform>Delete %n place</numerusform>
            <numerusform>Delete %n places</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a place out of a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected: select characters first (V), or paint them with the walk brush (W).</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Let %n character(s) walk</source>
        <translation>
            <numerusform>Let %n character walk</numerusform>
            <numerusform>Let %n characters walk</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentTree</name>
    <message>
        <source>Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n in it · %1</source>
        <translation>
            <numerusform>%n in it · %1</numerusform>
            <numerusform>%n in it · %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeaturePreview</name>
    <message>
        <source>Nobody of the scene&apos;s templates can show it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeatureRows</name>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeaturesDock</name>
    <message>
        <source>Features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever bears the value becomes what you set here, with it. Else only those are who come to bear it from now on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New features, and files of features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a value to the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the chosen value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select who bears the chosen value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or F2: rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A feature is what people are like: an emotion, an outfit, a team. The button above adds one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The feature has no values yet: + adds one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n bear it and change with it</source>
        <translation>
            <numerusform>%n bears it and changes with it</numerusform>
            <numerusform>%n bear it and change with it</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody bears it yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take from a File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features (*%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be saved: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take Features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features taken from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give to who is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select who bears it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the chosen value to who is selected, or to all where nobody is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint the chosen value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint It</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FieldForm</name>
    <message>
        <source>Scripts bring brushes along: a Python class with apply(selection), made known with crowdbrush.register_brush(MyBrush), has its place in the palette and its settings here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All tintable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no name yet; the Rules panel gives it one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose in the Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any, by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In no group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it out of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take whoever is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected: click somebody first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character %1, who is gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All get the value that was ticked first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sitting</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FindDialog</name>
    <message>
        <source>Find an Action, a Brush, a Panel or a Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” would do nothing now: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::GroupsDock</name>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new group of those who are selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected characters into the active group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the characters of the active group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the active group; its characters stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In no group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden: click to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown: click to hide, with Alt to show it alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked: click to let brushes work on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to lock: no brush touches it then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock or unlock a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select These Characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the Selected Out of Their Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the Selected In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show It Alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk as One Party</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Party or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of them take the same branch of a path and keep together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Group of the Selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::HandEditsPanel</name>
    <message>
        <source>Edits by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off: the take is seen as it was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the selected characters of the take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select those whom the chosen edit is for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the chosen edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later or Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower or Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand Still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside Their Way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change an edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n character(s)</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody Else</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::HistoryDock</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in memory, %2 on disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in memory: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay on the spot; the program moves the character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise or lower it until its lowest point is on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As &amp;Proposed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and one more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Import &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>This one as it is here, and the %n other file(s) as proposed</source>
        <translation>
            <numerusform>This one as it is here, and the other file as proposed</numerusform>
            <numerusform>This one as it is here, and the %n other files as proposed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::IndividualDock</name>
    <message>
        <source>Metres along %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is selected. Press V and click somebody.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;, number %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand up: the seat is free again</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n seated</source>
        <translation>
            <numerusform>%n seated</numerusform>
            <numerusform>%n seated</numerusform>
        </translation>
    </message>
    <message>
        <source>row %1, wedge %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint; a click chooses a colour, a right click takes it off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names or numbers of tags from 1 to 64, as brave, 3-5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%n characters&lt;/b&gt;</source>
        <translation>
            <numerusform>&lt;b&gt;%n character&lt;/b&gt;</numerusform>
            <numerusform>&lt;b&gt;%n characters&lt;/b&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode of the tint of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the tint multiplies the colour that is there or replaces it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LibraryDialog</name>
    <message>
        <source>Add from Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose whom to paint with; Ctrl or Shift and a click choose several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is in the scene already</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LightDock</name>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready-Made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sun, sky and colours of a time of day; the ground stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add: %1. Then click what it is to shine on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticked: it is on. Double click or F2: rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sun and sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n lights are on; the strongest %1 of them shine.</source>
        <translation>
            <numerusform>%n light is on; the strongest %1 of them shine.</numerusform>
            <numerusform>%n lights are on; the strongest %1 of them shine.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch a light on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch a light off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the picture, while Select is chosen: drag the lamp, with Shift up and down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click what it is to shine on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add: a spotlight that goes with somebody. Then click him</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click whom it is to follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can be dragged in the picture with the tool Select.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the picture, while Select is chosen: drag the lamp, with Shift up and down, the edge of its cone, or what it shines on; with Ctrl onto somebody, and it goes with him.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change sun, sky or air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the chosen lamp in the picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LooksDock</name>
    <message>
        <source>Looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The View as It Is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: draw the view so. Double click or F2: rename.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A look is a style with a light, a background and outlines of its own, under a name: studio, evening, comic. + adds one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take Looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks (*%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks taken from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be saved: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: draw the view as the scene is lit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::MarkRecorder</name>
    <message>
        <source>Record “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Record %n mark(s)</source>
        <translation>
            <numerusform>Record %n mark</numerusform>
            <numerusform>Record %n marks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::MissingAssetsDialog</name>
    <message>
        <source>Missing Assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Was at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Locate…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Template</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n asset(s) of this scene could not be loaded. The scene is intact and can be saved without loss; what they draw is not shown. When one is found, the others are looked for near it.</source>
        <translation>
            <numerusform>One asset of this scene could not be loaded. The scene is intact and can be saved without loss; what it draws is not shown.</numerusform>
            <numerusform>%n assets of this scene could not be loaded. The scene is intact and can be saved without loss; what they draw is not shown. When one is found, the others are looked for near it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::NamesForm</name>
    <message>
        <source>Tags and numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names and colours of tags, and numbers of your own that rules can ask for and change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a tag a name and a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A number that everybody has, as patience or hunger: rules ask for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the tag in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget a tag’s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody begins with less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody begins with more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All 64 tags have names already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name a tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are %1 numbers already, as many as can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n kept</source>
        <translation>
            <numerusform>%n kept</numerusform>
            <numerusform>%n kept</numerusform>
        </translation>
    </message>
    <message>
        <source>Forget the name; characters keep the tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many characters begin with what Keep Pose has kept; press to let all begin between the two again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::NumberField</name>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::PlacementForm</name>
    <message>
        <source>Who sits in its seats goes with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::PresetsDock</name>
    <message>
        <source>Brush presets (*.brush)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search names and #tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the brush as it is set now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take presets from files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a click sets it so. F2 gives another name; words with # are tags.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brushes that you set well can be kept here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a brush first: presets keep how it is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set to the brush of now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::PropertyLegend</name>
    <message>
        <source>What people are coloured by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: select them. Shift+click: select them as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is there yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RecallForm</name>
    <message>
        <source>Only in this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When one is recalled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it plays the scene stays as it is, and Stop gives it back. The keys always do so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only who is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others of the state stay as they are, also when keys recall.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RelationsDock</name>
    <message>
        <source>Relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arcs to whom the selected are related; of all where nobody is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a kind of relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relate each of the selected to each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the relation away from the selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select who has such a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select also who is related so to the selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen kind with its relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or F2: rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n relations of this kind</source>
        <translation>
            <numerusform>%n relation of this kind</numerusform>
            <numerusform>%n relations of this kind</numerusform>
        </translation>
    </message>
    <message>
        <source>A relation is who belongs to whom. The button above adds a kind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is related so yet: drag with the relation brush.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relate Each of the Selected to Each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take It Away from the Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select Who Has It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grow Selection to Those Related So</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint the chosen relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint It</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RuleCommands</name>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test on Selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test the rule on the selected characters, or on all, while it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a rule, or a ready-made set of rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A New Rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reorder the rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add rules: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a rule that begins with an event to try it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Play first: rules act while it plays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New rule %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Chosen in %n other rule(s) too, where it was still open</source>
        <translation>
            <numerusform>Chosen in %n other rule too, where it was still open</numerusform>
            <numerusform>Chosen in %n other rules too, where it was still open</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RuleEditor</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ only if…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ then…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as often as it comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds something to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>either</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier, or into or out of what repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later, or into or out of what repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this and what is in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds something to do in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ or…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds another one to choose among</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before it comes again for the same character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So often for the same character</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RulesDock</name>
    <message>
        <source>Rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rules yet. “Add” has ready-made ones to begin with; the event brush (E) sets them off while it plays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fired, while it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log only the selected characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SceneDock</name>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n seats</source>
        <translation>
            <numerusform>%n seat</numerusform>
            <numerusform>%n seats</numerusform>
        </translation>
    </message>
    <message>
        <source>missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go There</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set to This View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locate File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep This View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Stage…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Template…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select These Characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The look that the view takes on with this camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As It Is Elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks are made in the panel Looks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SelectedFirings</name>
    <message>
        <source>a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, at %2 s, for %n character(s)</source>
        <translation>
            <numerusform>%1, at %2 s, for one character</numerusform>
            <numerusform>%1, at %2 s, for %n characters</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SessionControl</name>
    <message numerus="yes">
        <source>Keep the pose of %n character(s)</source>
        <translation>
            <numerusform>Keep the pose of %n character</numerusform>
            <numerusform>Keep the pose of %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>Take it from take &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::StatesDock</name>
    <message>
        <source>States</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep how they are now as a new state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall the chosen state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep how they are now as the chosen state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new state is of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the whole crowd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of whom a new state is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Double click or Shift+F%2: recall. F2: rename.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Double click: recall. F2: rename.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A state keeps how the crowd is now, and gives it back later: calm, cheering, disappointed. + keeps one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select its characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall only in this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline in the picture who differs from the chosen state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Different: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody whom it keeps is there any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are like that now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of %1 out of %2 characters. %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::StrokesDock</name>
    <message>
        <source>Strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw everything random about this stroke anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay this stroke with the brush as it is set now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the brush as it is set for this stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nobody now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last strokes are listed here. Their settings can be changed until something else is edited.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laid anew: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whom this met depends on more than the scene: it was playing, clips were still being loaded, or people got back what they had. They stay the ones it met, until its area is changed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SurfaceForm</name>
    <message>
        <source>Body radius, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body height, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower places are not walked under</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest step, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steepest slope, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being found: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Found: %n areas</source>
        <translation>
            <numerusform>Found: %n area</numerusform>
            <numerusform>Found: %n areas</numerusform>
        </translation>
    </message>
    <message>
        <source>Open ground. It is looked at once somebody walks among a stage, obstacles or painted ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where characters can walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far characters keep from walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change where characters can walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show on the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours the ground of the stages where characters can walk</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakeFigures</name>
    <message>
        <source>The whole takes are being compared: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the whole take everybody is as in &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the whole take %1 of %2 are elsewhere than in &quot;%3&quot; at some time: from %4 on, %5 m at most, at %6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Up to %n character(s) are there in one of them only.</source>
        <translation>
            <numerusform>Up to %n character is there in one of them only.</numerusform>
            <numerusform>Up to %n characters are there in one of them only.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakeShelf</name>
    <message>
        <source>Take %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep take &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Retake %n character(s)</source>
        <translation>
            <numerusform>Retake %n character</numerusform>
            <numerusform>Retake %n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>There are as many takes as there can be. Delete some first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show take &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the scene instead of a take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete take &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename take to &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another take is called &quot;%1&quot; already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakesDock</name>
    <message>
        <source>Takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what has been played as a take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the chosen take as ghosts beside what is shown, with how far apart everybody is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected characters again, in the play range or else from the moment shown on: everybody else does what he did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the chosen take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n character(s)</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2. Enter shows it, F2 renames it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene as it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter shows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The take is being kept: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play, then keep what was played. A take can be seen again whatever becomes of paths, rules and marks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People move as in the take: what they are told and where they are to go counts for the scene as it plays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 everybody is as in &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1, %2 of %3 are elsewhere than in &quot;%4&quot;: %5 m on average, %6 m at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n character(s) taken again: &quot;%1&quot;.</source>
        <translation>
            <numerusform>%n character taken again: &quot;%1&quot;.</numerusform>
            <numerusform>%n characters taken again: &quot;%1&quot;.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the end somebody is brought back over %1 m: choose a longer stretch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide Ghosts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See as Ghosts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play on from the moment shown, as a run that can be told what to do; the take stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody walks or follows rules here: there is nothing to keep yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n character(s) are there in one of them only.</source>
        <translation>
            <numerusform>%n character is there in one of them only.</numerusform>
            <numerusform>%n characters are there in one of them only.</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;%1&quot; is kept. It begins at %2 s, where the run did.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplateDelegate</name>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplatePreview</name>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locate File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticked templates are painted by the create brush; a double click paints one alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the chosen template comes in the mix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add from the library of built-in characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import templates from files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add from Library…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Templates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TimelineDock</name>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record: cues, states and events become marks of the timeline as they are performed while it plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mark before this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mark after this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A marker at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all marks, and all that has been played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What times are shown in, and caught by when marks are dragged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a mark to see what happens there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n marks are chosen: drag them, or remove them.</source>
        <translation>
            <numerusform>%n mark is chosen: drag it, or remove it.</numerusform>
            <numerusform>%n marks are chosen: drag them, or remove them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n characters, as it was recorded.</source>
        <translation>
            <numerusform>For %n character, as it was recorded.</numerusform>
            <numerusform>For %n characters, as it was recorded.</numerusform>
        </translation>
    </message>
    <message>
        <source>Change a mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is played begins at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is played ends at this moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play over and over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And one more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
    <message>
        <source>From this moment on the camera looks as the view does now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view looks through the timeline&apos;s camera, where there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the side away, or back from the edge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TimelineView</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, at %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show This Moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to see what has been played; with Shift held, what is to be played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play from Here On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play until Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play All Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) copied: Ctrl+V puts them where the moment shown is</source>
        <translation>
            <numerusform>%n mark copied: Ctrl+V puts it where the moment shown is</numerusform>
            <numerusform>%n marks copied: Ctrl+V puts them where the moment shown is</numerusform>
        </translation>
    </message>
    <message>
        <source>The marks that were copied are not there any more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ToolController</name>
    <message>
        <source>Brush size: %1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no ground under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a point in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nobody under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click somebody in the picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ValueSlider</name>
    <message>
        <source>“%1” is no number: the value stays as it was.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ViewportOverlay</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and one more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ViewportWidget</name>
    <message>
        <source>This scene is empty.
Drop a character (.glb) or a stage here, or open a scene from the File menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it back (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is here yet.
Drag over the ground: characters come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is here yet.
Press C and paint characters on the ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding out where characters can walk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing up to this moment once more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animations are not prepared: some characters stand still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on preparing them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing animations: %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop: whose animation is not ready stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory for prepared animations is used up: some characters stand still. The preferences set its size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory of the graphics card is used up: characters and pictures are coarser. Fewer templates, or other programs closed, make room.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>crowd::widgets::WelcomePage</name>
    <message>
        <source>Theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>City</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stadium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint a crowd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show this page at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready-made scenes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open “%1” as a new scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Empty &amp;Theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Empty &amp;Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scenes yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose whom to paint with in the scene behind this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character &amp;Library…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
