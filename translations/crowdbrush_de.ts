<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New &amp;Theatre</source>
        <translation>Neues &amp;Theater</translation>
    </message>
    <message>
        <source>Start with the empty theatre</source>
        <translation>Mit dem leeren Theater beginnen</translation>
    </message>
    <message>
        <source>New &amp;Ground</source>
        <translation>Neuer &amp;Boden</translation>
    </message>
    <message>
        <source>Start with empty ground</source>
        <translation>Mit leerem Boden beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Eine Szene öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Sichern</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Die Szene sichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Sichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Die Szene unter anderem Namen sichern</translation>
    </message>
    <message>
        <source>&amp;Collect Assets</source>
        <translation>&amp;Dateien sammeln</translation>
    </message>
    <message>
        <source>Save the scene with copies of all its models beside it</source>
        <translation>Die Szene mit Kopien aller Modelle daneben sichern</translation>
    </message>
    <message>
        <source>&amp;Import Template…</source>
        <translation>&amp;Vorlage importieren …</translation>
    </message>
    <message>
        <source>Bring in an animated glTF model to paint with</source>
        <translation>Ein animiertes glTF-Modell zum Malen hereinholen</translation>
    </message>
    <message>
        <source>Import Sta&amp;ge…</source>
        <translation>Büh&amp;ne importieren …</translation>
    </message>
    <message>
        <source>Bring in a glTF model to stand on</source>
        <translation>Ein glTF-Modell hereinholen, auf dem man steht</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave Crowdbrush</source>
        <translation>Crowdbrush verlassen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Zurückgenommenes wiederholen</translation>
    </message>
    <message>
        <source>&amp;Delete Selected</source>
        <translation>Ausgewählte &amp;löschen</translation>
    </message>
    <message>
        <source>Remove the selected people</source>
        <translation>Die ausgewählten Personen entfernen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Alle auswählen</translation>
    </message>
    <message>
        <source>Select everybody</source>
        <translation>Jeden auswählen</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>&amp;Keinen auswählen</translation>
    </message>
    <message>
        <source>Select nobody</source>
        <translation>Niemanden auswählen</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>Auswahl &amp;umkehren</translation>
    </message>
    <message>
        <source>Select those who are not selected</source>
        <translation>Die nicht Ausgewählten auswählen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Theme, mouse, autosave, memory, shortcuts</source>
        <translation>Farben, Maus, Sicherung, Speicher, Tasten</translation>
    </message>
    <message>
        <source>&amp;Frame Selection</source>
        <translation>Auswahl &amp;zeigen</translation>
    </message>
    <message>
        <source>Show the selected people; everything when nobody is selected</source>
        <translation>Die Ausgewählten zeigen; alles, wenn niemand ausgewählt ist</translation>
    </message>
    <message>
        <source>Frame &amp;All</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Show the whole scene</source>
        <translation>Die ganze Szene zeigen</translation>
    </message>
    <message>
        <source>From the F&amp;ront</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>Look at the scene from the front</source>
        <translation>Die Szene von vorn ansehen</translation>
    </message>
    <message>
        <source>From the &amp;Side</source>
        <translation>Von der &amp;Seite</translation>
    </message>
    <message>
        <source>Look at the scene from the side</source>
        <translation>Die Szene von der Seite ansehen</translation>
    </message>
    <message>
        <source>From Abo&amp;ve</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Look at the scene from above</source>
        <translation>Die Szene von oben ansehen</translation>
    </message>
    <message>
        <source>&amp;Perspective or Orthographic</source>
        <translation>&amp;Perspektivisch oder parallel</translation>
    </message>
    <message>
        <source>Change between perspective and orthographic projection</source>
        <translation>Zwischen perspektivischer und paralleler Projektion wechseln</translation>
    </message>
    <message>
        <source>&amp;Keep This View</source>
        <translation>Ansicht &amp;behalten</translation>
    </message>
    <message>
        <source>Add a camera of the scene where the view is now</source>
        <translation>Eine Kamera der Szene dort hinzufügen, wo die Ansicht ist</translation>
    </message>
    <message>
        <source>Seat &amp;Grid</source>
        <translation>Sitz&amp;raster</translation>
    </message>
    <message>
        <source>Create people only on free seats</source>
        <translation>Personen nur auf freie Sitze setzen</translation>
    </message>
    <message>
        <source>Gr&amp;ound Grid</source>
        <translation>B&amp;odenraster</translation>
    </message>
    <message>
        <source>Show a grid of metres on the ground</source>
        <translation>Ein Meterraster am Boden zeigen</translation>
    </message>
    <message>
        <source>S&amp;hadows</source>
        <translation>Sc&amp;hatten</translation>
    </message>
    <message>
        <source>Show a soft shadow under everybody</source>
        <translation>Unter jedem einen weichen Schatten zeigen</translation>
    </message>
    <message>
        <source>&amp;Lighting</source>
        <translation>Be&amp;leuchtung</translation>
    </message>
    <message>
        <source>Light the scene; otherwise plain colours</source>
        <translation>Die Szene beleuchten; sonst einfache Farben</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>Voll&amp;bild</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Den Bildschirm mit dem Fenster füllen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Ab&amp;spielen</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Rewind</source>
        <translation>&amp;Zurückspulen</translation>
    </message>
    <message>
        <source>Back to the start of time</source>
        <translation>Zurück zum Anfang der Zeit</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>&amp;Größerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush larger</source>
        <translation>Den Pinsel vergrößern</translation>
    </message>
    <message>
        <source>&amp;Smaller Brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush smaller</source>
        <translation>Den Pinsel verkleinern</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>Alle Tafeln an ihren Platz zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>What keys and mouse buttons do</source>
        <translation>Was Tasten und Maustasten tun</translation>
    </message>
    <message>
        <source>&amp;About Crowdbrush</source>
        <translation>&amp;Über Crowdbrush</translation>
    </message>
    <message>
        <source>What this is, and its version</source>
        <translation>Was dies ist, und seine Version</translation>
    </message>
    <message>
        <source>Select people, move them, delete them</source>
        <translation>Personen auswählen, verschieben, löschen</translation>
    </message>
    <message>
        <source>Turn, shift and zoom the view</source>
        <translation>Die Ansicht drehen, schieben, zoomen</translation>
    </message>
    <message>
        <source>Spray new people into the scene</source>
        <translation>Neue Personen in die Szene sprühen</translation>
    </message>
    <message>
        <source>Spray people away</source>
        <translation>Personen wegsprühen</translation>
    </message>
    <message>
        <source>Recolour the people under the brush</source>
        <translation>Die Personen unter dem Pinsel umfärben</translation>
    </message>
    <message>
        <source>Turn the people under the brush</source>
        <translation>Die Personen unter dem Pinsel drehen</translation>
    </message>
    <message>
        <source>Give the people under the brush another animation</source>
        <translation>Den Personen unter dem Pinsel eine andere Animation geben</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Navigieren</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Schaffen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>&amp;Färben</translation>
    </message>
    <message>
        <source>O&amp;rientation</source>
        <translation>&amp;Richtung</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>A&amp;nimation</translation>
    </message>
</context>
<context>
    <name>BrushTexts</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Spray</source>
        <translation>Sprühen</translation>
    </message>
    <message>
        <source>All in the circle</source>
        <translation>Alle im Kreis</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>People per m²</source>
        <translation>Personen je m²</translation>
    </message>
    <message>
        <source>Seats filled, %</source>
        <translation>Besetzte Sitze, %</translation>
    </message>
    <message>
        <source>Rate, a second</source>
        <translation>Rate, je Sekunde</translation>
    </message>
    <message>
        <source>Strength, %</source>
        <translation>Stärke, %</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Richtung, °</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Density: %1 people per m²</source>
        <translation>Dichte: %1 Personen je m²</translation>
    </message>
    <message>
        <source>Seats filled: %1 %</source>
        <translation>Besetzte Sitze: %1 %</translation>
    </message>
    <message>
        <source>Rate: %1 a second</source>
        <translation>Rate: %1 je Sekunde</translation>
    </message>
    <message>
        <source>Strength: %1 %</source>
        <translation>Stärke: %1 %</translation>
    </message>
    <message>
        <source>Direction: %1°</source>
        <translation>Richtung: %1°</translation>
    </message>
    <message>
        <source>Speed: × %1</source>
        <translation>Tempo: × %1</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message numerus="yes">
        <source>%n people created</source>
        <translation>
            <numerusform>%n Person geschaffen</numerusform>
            <numerusform>%n Personen geschaffen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people deleted</source>
        <translation>
            <numerusform>%n Person gelöscht</numerusform>
            <numerusform>%n Personen gelöscht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people coloured</source>
        <translation>
            <numerusform>%n Person gefärbt</numerusform>
            <numerusform>%n Personen gefärbt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people turned</source>
        <translation>
            <numerusform>%n Person gedreht</numerusform>
            <numerusform>%n Personen gedreht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people do something else</source>
        <translation>
            <numerusform>%n Person tut etwas anderes</numerusform>
            <numerusform>%n Personen tun etwas anderes</numerusform>
        </translation>
    </message>
    <message>
        <source>The stroke was taken back.</source>
        <translation>Der Strich wurde zurückgenommen.</translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Drag: create people · + −: how many</source>
        <translation>Ziehen: Personen schaffen · + −: wie viele</translation>
    </message>
    <message>
        <source>Drag: delete people · + −: how fast</source>
        <translation>Ziehen: Personen löschen · + −: wie schnell</translation>
    </message>
    <message>
        <source>Drag: colour people · + −: strength</source>
        <translation>Ziehen: Personen färben · + −: Stärke</translation>
    </message>
    <message>
        <source>Drag: turn people · + −: direction</source>
        <translation>Ziehen: Personen drehen · + −: Richtung</translation>
    </message>
    <message>
        <source>Drag: change what people do · + −: speed</source>
        <translation>Ziehen: ändern, was Personen tun · + −: Tempo</translation>
    </message>
    <message>
        <source>Left: point · Middle: circle · Right: rectangle · Alt or Space and drag: navigate · [ ]: size</source>
        <translation>Links: Punkt · Mitte: Kreis · Rechts: Rechteck · Alt oder Leertaste und ziehen: navigieren · [ ]: Größe</translation>
    </message>
    <message>
        <source>Right button: brushes · Middle button, Alt or Space and drag: navigate · [ ], Ctrl+wheel, Shift+drag: size</source>
        <translation>Rechte Taste: Pinsel · Mittlere Taste, Alt oder Leertaste und ziehen: navigieren · [ ], Strg+Rad, Umschalt+ziehen: Größe</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message numerus="yes">
        <source>Create %n individual(s)</source>
        <translation>
            <numerusform>%n Person schaffen</numerusform>
            <numerusform>%n Personen schaffen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n individual(s)</source>
        <translation>
            <numerusform>%n Person löschen</numerusform>
            <numerusform>%n Personen löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour %n individual(s)</source>
        <translation>
            <numerusform>%n Person färben</numerusform>
            <numerusform>%n Personen färben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n individual(s)</source>
        <translation>
            <numerusform>%n Person drehen</numerusform>
            <numerusform>%n Personen drehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Animate %n individual(s)</source>
        <translation>
            <numerusform>%n Person animieren</numerusform>
            <numerusform>%n Personen animieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n individual(s)</source>
        <translation>
            <numerusform>%n Person verschieben</numerusform>
            <numerusform>%n Personen verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody under the brush</source>
        <translation>Niemand unter dem Pinsel</translation>
    </message>
    <message>
        <source>No free seat under the brush</source>
        <translation>Kein freier Sitz unter dem Pinsel</translation>
    </message>
    <message>
        <source>Choose a template to create first</source>
        <translation>Zuerst eine Vorlage zum Schaffen wählen</translation>
    </message>
    <message>
        <source>The chosen template is not loaded</source>
        <translation>Die gewählte Vorlage ist nicht geladen</translation>
    </message>
    <message>
        <source>Too steep to stand on</source>
        <translation>Zu steil zum Stehen</translation>
    </message>
    <message>
        <source>Nothing to stand on under the brush</source>
        <translation>Unter dem Pinsel ist nichts, worauf man steht</translation>
    </message>
    <message>
        <source>Others are nearer than the minimal distance</source>
        <translation>Andere sind näher als der Mindestabstand</translation>
    </message>
    <message>
        <source>The area is too large for this density: zoom in or lower the density</source>
        <translation>Die Fläche ist zu groß für diese Dichte: näher heran oder die Dichte senken</translation>
    </message>
    <message>
        <source>The area is too small for anybody at this density</source>
        <translation>Die Fläche ist bei dieser Dichte für jeden zu klein</translation>
    </message>
    <message>
        <source>All of them already have this colour</source>
        <translation>Alle haben schon diese Farbe</translation>
    </message>
    <message>
        <source>None of them has the chosen slot</source>
        <translation>Keiner von ihnen hat den gewählten Slot</translation>
    </message>
    <message>
        <source>All of them already face this way</source>
        <translation>Alle schauen schon dorthin</translation>
    </message>
    <message>
        <source>All of them already move like this</source>
        <translation>Alle bewegen sich schon so</translation>
    </message>
    <message>
        <source>None of them has a chosen clip</source>
        <translation>Keiner von ihnen hat einen gewählten Clip</translation>
    </message>
    <message>
        <source>The brush is set to change nothing</source>
        <translation>Der Pinsel ist so eingestellt, dass er nichts ändert</translation>
    </message>
    <message>
        <source>Drag to show the direction</source>
        <translation>Ziehen, um die Richtung zu zeigen</translation>
    </message>
</context>
<context>
    <name>FlySession</name>
    <message>
        <source>Flying at %1 m/s – W A S D, Q and E, wheel for the speed, click to land, Escape to go back</source>
        <translation>Flug mit %1 m/s – W A S D, Q und E, Rad für das Tempo, Klick landet, Esc kehrt zurück</translation>
    </message>
    <message>
        <source>Flying at %1 m/s – W A S D, Q and E, wheel for the speed, release to land, Escape to go back</source>
        <translation>Flug mit %1 m/s – W A S D, Q und E, Rad für das Tempo, Loslassen landet, Esc kehrt zurück</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>Y up (glTF)</source>
        <translation>Y oben (glTF)</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z oben</translation>
    </message>
    <message>
        <source>Z down</source>
        <translation>Z unten</translation>
    </message>
    <message>
        <source>X up</source>
        <translation>X oben</translation>
    </message>
    <message>
        <source>X down</source>
        <translation>X unten</translation>
    </message>
    <message>
        <source>Y down</source>
        <translation>Y unten</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Ab&amp;spielen</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
</context>
<context>
    <name>NavigateTool</name>
    <message>
        <source>Drag: orbit · Shift: pan · Ctrl: nearer, farther · Wheel: towards the cursor · Right button or Shift+F: fly with WASD · F: show the selection</source>
        <translation>Ziehen: umkreisen · Umschalt: schieben · Strg: näher, ferner · Rad: zum Zeiger hin · Rechte Taste oder Umschalt+F: mit WASD fliegen · F: Auswahl zeigen</translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>Click: select · Shift: add · Ctrl: toggle · Drag: rectangle, or move the selected · Delete: remove · F: show the selection</source>
        <translation>Klick: auswählen · Umschalt: dazu · Strg: umschalten · Ziehen: Rechteck, oder Ausgewählte verschieben · Entf: entfernen · F: Auswahl zeigen</translation>
    </message>
</context>
<context>
    <name>SelectionCommands</name>
    <message>
        <source>Nobody is selected: there is nobody to delete.</source>
        <translation>Niemand ist ausgewählt: Es gibt niemanden zu löschen.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n individual(s)</source>
        <translation>
            <numerusform>%n Person löschen</numerusform>
            <numerusform>%n Personen löschen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Navigate</source>
        <translation>Navigieren</translation>
    </message>
    <message>
        <source>Create Brush</source>
        <translation>Schaffen</translation>
    </message>
    <message>
        <source>Delete Brush</source>
        <translation>Löschpinsel</translation>
    </message>
    <message>
        <source>Colour Brush</source>
        <translation>Farbpinsel</translation>
    </message>
    <message>
        <source>Orientation Brush</source>
        <translation>Richtungspinsel</translation>
    </message>
    <message>
        <source>Animation Brush</source>
        <translation>Animationspinsel</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>There is no camera “%1” in this scene.</source>
        <translation>In dieser Szene gibt es keine Kamera „%1“.</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add Camera “%1”</source>
        <translation>Kamera „%1“ hinzufügen</translation>
    </message>
    <message>
        <source>Update Camera “%1”</source>
        <translation>Kamera „%1“ aktualisieren</translation>
    </message>
    <message>
        <source>Remove Camera “%1”</source>
        <translation>Kamera „%1“ entfernen</translation>
    </message>
    <message>
        <source>Rename Camera “%1”</source>
        <translation>Kamera „%1“ umbenennen</translation>
    </message>
</context>
<context>
    <name>crowd::app::AssetController</name>
    <message>
        <source>glTF models (*.glb *.gltf);;All files (*)</source>
        <translation>glTF-Modelle (*.glb *.gltf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import Template</source>
        <translation>Vorlage importieren</translation>
    </message>
    <message>
        <source>Import Stage</source>
        <translation>Bühne importieren</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Use “%1” as a template to paint with, or as the stage?</source>
        <translation>„%1“ als Vorlage zum Malen oder als Bühne verwenden?</translation>
    </message>
    <message>
        <source>&amp;Template</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>&amp;Stage</source>
        <translation>&amp;Bühne</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>The template could not be imported</source>
        <translation>Die Vorlage konnte nicht importiert werden</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>%1 wird importiert …</translation>
    </message>
    <message>
        <source>“%1” is ready: the create brush paints it.</source>
        <translation>„%1“ ist bereit: Der Pinsel „Schaffen“ malt damit.</translation>
    </message>
    <message>
        <source>The stage could not be imported</source>
        <translation>Die Bühne konnte nicht importiert werden</translation>
    </message>
    <message numerus="yes">
        <source>%n people are of this template; delete them first.</source>
        <translation>
            <numerusform>%n Person ist von dieser Vorlage; zuerst löschen.</numerusform>
            <numerusform>%n Personen sind von dieser Vorlage; zuerst löschen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove Template</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Locate “%1”</source>
        <translation>„%1“ suchen</translation>
    </message>
    <message>
        <source>The template could not be read</source>
        <translation>Die Vorlage konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Locate Template</source>
        <translation>Vorlage suchen</translation>
    </message>
    <message>
        <source>The stage could not be read</source>
        <translation>Die Bühne konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Locate Stage</source>
        <translation>Bühne suchen</translation>
    </message>
    <message>
        <source>Missing Assets</source>
        <translation>Fehlende Dateien</translation>
    </message>
    <message numerus="yes">
        <source>%n asset(s) of this scene could not be loaded. The scene is intact and can be saved without loss; what they draw is not shown.</source>
        <translation>
            <numerusform>%n Datei dieser Szene konnte nicht geladen werden. Die Szene ist unversehrt und lässt sich verlustfrei speichern; was die Datei zeigt, fehlt im Bild.</numerusform>
            <numerusform>%n Dateien dieser Szene konnten nicht geladen werden. Die Szene ist unversehrt und lässt sich verlustfrei speichern; was die Dateien zeigen, fehlt im Bild.</numerusform>
        </translation>
    </message>
    <message>
        <source>To point the scene at a file that has moved, choose Locate in the Templates or the Scene panel.</source>
        <translation>Ist eine Datei umgezogen, in der Tafel „Vorlagen“ oder „Szene“ „Datei suchen“ wählen.</translation>
    </message>
</context>
<context>
    <name>crowd::app::BackgroundTask</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>crowd::app::FileController</name>
    <message>
        <source>Crowdbrush scenes (*.crowd)</source>
        <translation>Crowdbrush-Szenen (*.crowd)</translation>
    </message>
    <message>
        <source>Preparing a new scene…</source>
        <translation>Neue Szene wird vorbereitet …</translation>
    </message>
    <message>
        <source>Open Scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>Ungesicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Crowdbrush kept unsaved changes of “%1” from %2. Open them?

Otherwise they are thrown away and the scene opens as it was saved.</source>
        <translation>Crowdbrush hat ungesicherte Änderungen an „%1“ vom %2 aufgehoben. Öffnen?

Sonst werden sie verworfen, und die Szene öffnet sich, wie sie gesichert wurde.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>The scene could not be opened</source>
        <translation>Die Szene konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Save Scene As</source>
        <translation>Szene sichern unter</translation>
    </message>
    <message>
        <source>The scene could not be saved</source>
        <translation>Die Szene konnte nicht gesichert werden</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>The assets could not be collected</source>
        <translation>Die Dateien konnten nicht gesammelt werden</translation>
    </message>
    <message>
        <source>Collect Assets</source>
        <translation>Dateien sammeln</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Ungesicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes. Save them?</source>
        <translation>„%1“ hat ungesicherte Änderungen. Sichern?</translation>
    </message>
    <message>
        <source>Crowdbrush kept a scene that was never saved, from %1. Open it?

Otherwise it is thrown away.</source>
        <translation>Crowdbrush hat eine nie gesicherte Szene vom %1 aufgehoben. Öffnen?

Sonst wird sie verworfen.</translation>
    </message>
    <message>
        <source>Loading %1…</source>
        <translation>%1 wird geladen …</translation>
    </message>
</context>
<context>
    <name>crowd::app::KeysDialog</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>paints with the active brush, or selects</source>
        <translation>malt mit dem aktiven Pinsel oder wählt aus</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>opens the brushes at the cursor</source>
        <translation>öffnet die Pinsel am Zeiger</translation>
    </message>
    <message>
        <source>Middle button, Alt + left</source>
        <translation>Mittlere Taste, Alt + links</translation>
    </message>
    <message>
        <source>turn the view; with Shift shift it</source>
        <translation>drehen die Ansicht; mit Umschalt verschieben sie sie</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>goes to the point under the cursor</source>
        <translation>geht auf den Punkt unter dem Zeiger zu</translation>
    </message>
    <message>
        <source>Ctrl + wheel, [ and ]</source>
        <translation>Strg + Rad, [ und ]</translation>
    </message>
    <message>
        <source>size of the brush</source>
        <translation>Größe des Pinsels</translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation>+ und −</translation>
    </message>
    <message>
        <source>main number of the brush</source>
        <translation>Hauptzahl des Pinsels</translation>
    </message>
    <message>
        <source>Space held</source>
        <translation>Leertaste gehalten</translation>
    </message>
    <message>
        <source>navigates with the left button; tapped it plays and pauses</source>
        <translation>navigiert mit der linken Taste; angetippt spielt und hält sie an</translation>
    </message>
    <message>
        <source>Shift + F</source>
        <translation>Umschalt + F</translation>
    </message>
    <message>
        <source>flies with W A S D and the mouse; Escape ends it</source>
        <translation>fliegt mit W A S D und der Maus; Esc beendet</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>takes the stroke in progress back, or selects nobody</source>
        <translation>nimmt den laufenden Strich zurück oder hebt die Auswahl auf</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
</context>
<context>
    <name>crowd::app::MainWindow</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Go to &amp;Camera</source>
        <translation>Zur &amp;Kamera</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1[*] – Crowdbrush</source>
        <translation>%1[*] – Crowdbrush</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>No scenes yet</source>
        <translation>Noch keine Szenen</translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation>Diese Liste &amp;leeren</translation>
    </message>
    <message>
        <source>The scene has no cameras</source>
        <translation>Die Szene hat keine Kameras</translation>
    </message>
    <message>
        <source>About Crowdbrush</source>
        <translation>Über Crowdbrush</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Crowdbrush %1&lt;/h3&gt;&lt;p&gt;An editor that paints crowds.&lt;/p&gt;&lt;p&gt;After “Crowdbrush: Interactive Authoring of Real-time Crowd Scenes”, Ulicny, de Heras Ciechomski and Thalmann, 2004.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Crowdbrush %1&lt;/h3&gt;&lt;p&gt;Ein Editor, der Menschenmengen malt.&lt;/p&gt;&lt;p&gt;Nach „Crowdbrush: Interactive Authoring of Real-time Crowd Scenes“, Ulicny, de Heras Ciechomski und Thalmann, 2004.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>crowd::app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Left paints, right opens the brushes</source>
        <translation>Links malt, rechts öffnet die Pinsel</translation>
    </message>
    <message>
        <source>Left a point, middle a circle, right a rectangle</source>
        <translation>Links Punkt, Mitte Kreis, rechts Rechteck</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Mouse buttons</source>
        <translation>Maustasten</translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation>Ungesichertes aufheben alle</translation>
    </message>
    <message>
        <source>Memory for keyframes</source>
        <translation>Speicher für Keyframes</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Memory and language change when Crowdbrush starts again.</source>
        <translation>Speicher und Sprache ändern sich beim nächsten Start.</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Those keys belong to “%1”.</source>
        <translation>Diese Tasten gehören zu „%1“.</translation>
    </message>
    <message>
        <source>All Back to Defaults</source>
        <translation>Alle zurücksetzen</translation>
    </message>
</context>
<context>
    <name>crowd::app::StatusPanel</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 ms · %2 triangles</source>
        <translation>%1 ms · %2 Dreiecke</translation>
    </message>
    <message>
        <source>Time of one picture, and what was drawn in it: %1 of %2 people</source>
        <translation>Dauer eines Bildes, und was darin gezeichnet wurde: %1 von %2 Personen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushForm</name>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>How often low (left) to high values (right) come: draw it</source>
        <translation>Wie oft niedrige (links) bis hohe Werte (rechts) vorkommen: zeichnen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Reaches</source>
        <translation>Erfasst</translation>
    </message>
    <message>
        <source>One</source>
        <translation>Einen</translation>
    </message>
    <message>
        <source>Spray</source>
        <translation>Sprühen</translation>
    </message>
    <message>
        <source>All in circle</source>
        <translation>Alle im Kreis</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>Pen pressure changes size</source>
        <translation>Stiftdruck ändert die Größe</translation>
    </message>
    <message>
        <source>Through</source>
        <translation>Hindurch</translation>
    </message>
    <message>
        <source>Also people hidden behind others or the stage</source>
        <translation>Auch Personen, die von anderen oder der Bühne verdeckt sind</translation>
    </message>
    <message>
        <source>Build up</source>
        <translation>Aufbauen</translation>
    </message>
    <message>
        <source>Each dab changes again whom it touches</source>
        <translation>Jeder Tupfer ändert erneut, wen er berührt</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>A direction</source>
        <translation>Eine Richtung</translation>
    </message>
    <message>
        <source>Along the stroke</source>
        <translation>Entlang des Strichs</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Ein Punkt</translation>
    </message>
    <message>
        <source>The viewer</source>
        <translation>Der Betrachter</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Point X</source>
        <translation>Punkt X</translation>
    </message>
    <message>
        <source>Point Z</source>
        <translation>Punkt Z</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Seats</source>
        <translation>Sitze</translation>
    </message>
    <message>
        <source>Only on free seats</source>
        <translation>Nur auf freie Sitze</translation>
    </message>
    <message>
        <source>Seat grid: people sit down where they may</source>
        <translation>Sitzraster: Personen setzen sich, wo sie dürfen</translation>
    </message>
    <message>
        <source>Ranks</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Rows counted from the front, as 1, 3-5</source>
        <translation>Reihen von vorn gezählt, etwa 1, 3-5</translation>
    </message>
    <message>
        <source>Wedges</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Wedges of seats, as 1, 3-5</source>
        <translation>Sitzblöcke, etwa 1, 3-5</translation>
    </message>
    <message>
        <source>Of the seats</source>
        <translation>Von den Sitzen</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source> /m²</source>
        <translation> /m²</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Height from</source>
        <translation>Höhe von</translation>
    </message>
    <message>
        <source>Height to</source>
        <translation>Höhe bis</translation>
    </message>
    <message>
        <source>Girth from</source>
        <translation>Breite von</translation>
    </message>
    <message>
        <source>Girth to</source>
        <translation>Breite bis</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Phase from</source>
        <translation>Phase von</translation>
    </message>
    <message>
        <source>Phase to</source>
        <translation>Phase bis</translation>
    </message>
    <message>
        <source>Clips (none: what suits)</source>
        <translation>Clips (keiner: was passt)</translation>
    </message>
    <message>
        <source>All tintable</source>
        <translation>Alle färbbaren</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Anstrich</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Slot</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Blend between the colours</source>
        <translation>Zwischen den Farben mischen</translation>
    </message>
    <message>
        <source>Another colour for each slot</source>
        <translation>Andere Farbe je Slot</translation>
    </message>
    <message>
        <source>Clips (none: as they are)</source>
        <translation>Clips (keiner: wie sie sind)</translation>
    </message>
    <message>
        <source>Change the phase</source>
        <translation>Phase ändern</translation>
    </message>
    <message>
        <source>Change the speed</source>
        <translation>Tempo ändern</translation>
    </message>
    <message>
        <source>Speed from</source>
        <translation>Tempo von</translation>
    </message>
    <message>
        <source>Speed to</source>
        <translation>Tempo bis</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushPaletteDock</name>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushPopup</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BrushSettingsDock</name>
    <message>
        <source>Brush Settings</source>
        <translation>Pinseleinstellungen</translation>
    </message>
    <message>
        <source>This tool has no settings. Choose a brush to set it.</source>
        <translation>Dieses Werkzeug hat keine Einstellungen. Einen Pinsel wählen.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ColourDock</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>The colour that is painted; where a gradient begins</source>
        <translation>Die Farbe, die gemalt wird; wo ein Verlauf beginnt</translation>
    </message>
    <message>
        <source>Where a gradient ends; the other colour of random</source>
        <translation>Wo ein Verlauf endet; die andere Farbe beim Zufall</translation>
    </message>
    <message>
        <source>The colour in hexadecimal, as #rrggbb</source>
        <translation>Die Farbe hexadezimal, als #rrggbb</translation>
    </message>
    <message>
        <source>Keep the colour as a swatch</source>
        <translation>Die Farbe als Farbfeld behalten</translation>
    </message>
    <message>
        <source>%1; a right click removes it</source>
        <translation>%1; ein Rechtsklick entfernt es</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ImportDialog</name>
    <message>
        <source>Walk on the spot; the program moves the character</source>
        <translation>Auf der Stelle gehen; das Programm bewegt die Figur</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Anheben</translation>
    </message>
    <message>
        <source>Root motion</source>
        <translation>Wurzelbewegung</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Ground speed</source>
        <translation>Lauftempo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::IndividualDock</name>
    <message>
        <source>Individual</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Metres along %1</source>
        <translation>Meter entlang %1</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Heading °</source>
        <translation>Richtung °</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Nobody is selected. Press V and click somebody.</source>
        <translation>Niemand ist ausgewählt. V drücken und jemanden anklicken.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;, number %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;, Nummer %2</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%n people&lt;/b&gt;</source>
        <translation>
            <numerusform>&lt;b&gt;%n Person&lt;/b&gt;</numerusform>
            <numerusform>&lt;b&gt;%n Personen&lt;/b&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Tint; choose a colour</source>
        <translation>Tönung; Farbe wählen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Change Individual</source>
        <translation>Person ändern</translation>
    </message>
    <message>
        <source>Change Clip</source>
        <translation>Clip ändern</translation>
    </message>
    <message>
        <source>Tint of %1</source>
        <translation>Tönung von %1</translation>
    </message>
    <message>
        <source>Change Tint</source>
        <translation>Tönung ändern</translation>
    </message>
    <message>
        <source>Change Outfit</source>
        <translation>Kleidung ändern</translation>
    </message>
    <message>
        <source>Show Part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Hide Part</source>
        <translation>Teil verbergen</translation>
    </message>
    <message>
        <source>Change Group</source>
        <translation>Gruppe ändern</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LightForm</name>
    <message>
        <source>Sun from</source>
        <translation>Sonne von</translation>
    </message>
    <message>
        <source>Sun height</source>
        <translation>Sonnenhöhe</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Change Light</source>
        <translation>Licht ändern</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::NumberField</name>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SceneDock</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Bühne</translation>
    </message>
    <message numerus="yes">
        <source>%n seats</source>
        <translation>
            <numerusform>%n Sitz</numerusform>
            <numerusform>%n Sitze</numerusform>
        </translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Remove Stage</source>
        <translation>Bühne entfernen</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Dorthin</translation>
    </message>
    <message>
        <source>Set to This View</source>
        <translation>Auf diese Ansicht setzen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Select These People</source>
        <translation>Diese Personen auswählen</translation>
    </message>
    <message>
        <source>Locate File…</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Keep This View</source>
        <translation>Ansicht behalten</translation>
    </message>
    <message>
        <source>Import Stage…</source>
        <translation>Bühne importieren …</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Ticked templates are painted by the create brush</source>
        <translation>Angekreuzte Vorlagen malt der Pinsel „Schaffen“</translation>
    </message>
    <message>
        <source>How often the template comes in the mix</source>
        <translation>Wie oft die Vorlage in der Mischung vorkommt</translation>
    </message>
    <message>
        <source>Import a template</source>
        <translation>Eine Vorlage importieren</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rename Template</source>
        <translation>Vorlage umbenennen</translation>
    </message>
    <message>
        <source>Import Template…</source>
        <translation>Vorlage importieren …</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Locate File…</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ToolController</name>
    <message>
        <source>Brush size: %1 px</source>
        <translation>Pinselgröße: %1 px</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ViewportWidget</name>
    <message>
        <source>This scene is empty.
Drop a character (.glb) or a stage here, or open a scene from the File menu.</source>
        <translation>Diese Szene ist leer.
Eine Figur (.glb) oder eine Bühne hierher ziehen oder im Menü „Datei“ eine Szene öffnen.</translation>
    </message>
    <message>
        <source>Nobody is here yet.
Press C and paint people on the ground.</source>
        <translation>Noch ist niemand hier.
C drücken und Personen auf den Boden malen.</translation>
    </message>
    <message>
        <source>Baking %1 of %2 clips</source>
        <translation>Clip %1 von %2 wird vorbereitet</translation>
    </message>
    <message>
        <source>The memory for baked animations is used up: some people stand still. The preferences set its size.</source>
        <translation>Der Speicher für Animationen ist voll: Manche Personen stehen still. Die Größe steht in den Einstellungen.</translation>
    </message>
</context>
</TS>
