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
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Die Szene speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Die Szene unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Collect Assets</source>
        <translation>&amp;Dateien sammeln</translation>
    </message>
    <message>
        <source>Save the scene with copies of all its models beside it</source>
        <translation>Die Szene mit Kopien aller Modelle daneben speichern</translation>
    </message>
    <message>
        <source>Bring in an animated glTF model to paint with</source>
        <translation>Ein animiertes glTF-Modell zum Malen hereinholen</translation>
    </message>
    <message>
        <source>I&amp;mport Stage…</source>
        <translation>Büh&amp;ne importieren …</translation>
    </message>
    <message>
        <source>Bring in a glTF model to stand on</source>
        <translation>Ein glTF-Modell hereinholen, auf dem man steht</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
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
        <source>&amp;Frame Selection</source>
        <translation>Auswahl &amp;zeigen</translation>
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
        <translation>S&amp;itzraster</translation>
    </message>
    <message>
        <source>Gr&amp;ound Grid</source>
        <translation>Bo&amp;denraster</translation>
    </message>
    <message>
        <source>Show a grid of metres on the ground</source>
        <translation>Ein Meterraster am Boden zeigen</translation>
    </message>
    <message>
        <source>Sha&amp;dows</source>
        <translation>Sc&amp;hatten</translation>
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
        <translation>Vollb&amp;ild</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Den Bildschirm mit dem Fenster füllen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>G&amp;rößerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush larger</source>
        <translation>Den Pinsel vergrößern</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
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
        <source>&amp;About Crowdbrush</source>
        <translation>&amp;Über Crowdbrush</translation>
    </message>
    <message>
        <source>What this is, and its version</source>
        <translation>Was dies ist, und seine Version</translation>
    </message>
    <message>
        <source>Turn, shift and zoom the view</source>
        <translation>Die Ansicht drehen, schieben, zoomen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Navigieren</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Erschaffen</translation>
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
        <translation>Ri&amp;chtung</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>Animati&amp;on</translation>
    </message>
    <message>
        <source>Go to Camera &amp;1</source>
        <translation>Zu Kamera &amp;1</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;1</source>
        <translation>Ansicht als Kamera &amp;1 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;2</source>
        <translation>Zu Kamera &amp;2</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;2</source>
        <translation>Ansicht als Kamera &amp;2 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;3</source>
        <translation>Zu Kamera &amp;3</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;3</source>
        <translation>Ansicht als Kamera &amp;3 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;4</source>
        <translation>Zu Kamera &amp;4</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;4</source>
        <translation>Ansicht als Kamera &amp;4 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;5</source>
        <translation>Zu Kamera &amp;5</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;5</source>
        <translation>Ansicht als Kamera &amp;5 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;6</source>
        <translation>Zu Kamera &amp;6</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;6</source>
        <translation>Ansicht als Kamera &amp;6 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;7</source>
        <translation>Zu Kamera &amp;7</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;7</source>
        <translation>Ansicht als Kamera &amp;7 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;8</source>
        <translation>Zu Kamera &amp;8</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;8</source>
        <translation>Ansicht als Kamera &amp;8 merken</translation>
    </message>
    <message>
        <source>Go to Camera &amp;9</source>
        <translation>Zu Kamera &amp;9</translation>
    </message>
    <message>
        <source>Keep View as Camera &amp;9</source>
        <translation>Ansicht als Kamera &amp;9 merken</translation>
    </message>
    <message>
        <source>Look through the scene&apos;s camera of this number</source>
        <translation>Durch die Kamera der Szene mit dieser Nummer sehen</translation>
    </message>
    <message>
        <source>Keep the present view as the scene&apos;s camera of this number</source>
        <translation>Die jetzige Ansicht als Kamera der Szene mit dieser Nummer merken</translation>
    </message>
    <message>
        <source>Picture &amp;Only</source>
        <translation>&amp;Nur das Bild</translation>
    </message>
    <message>
        <source>Hide panels and tool bar, or show them again</source>
        <translation>Bereiche und Werkzeugleiste verbergen oder wieder zeigen</translation>
    </message>
    <message>
        <source>Python &amp;Console</source>
        <translation>Python-&amp;Konsole</translation>
    </message>
    <message>
        <source>Type Python, with the open scene as &quot;scene&quot;</source>
        <translation>Python eintippen, mit der offenen Szene als „scene“</translation>
    </message>
    <message>
        <source>&amp;Run Script…</source>
        <translation>Skript &amp;ausführen …</translation>
    </message>
    <message>
        <source>Run a Python file on the open scene</source>
        <translation>Eine Python-Datei mit der offenen Szene ausführen</translation>
    </message>
    <message>
        <source>&amp;Stop Script</source>
        <translation>Skript an&amp;halten</translation>
    </message>
    <message>
        <source>Stop the script that runs</source>
        <translation>Das laufende Skript anhalten</translation>
    </message>
    <message>
        <source>What mouse buttons and keys do</source>
        <translation>Was Maustasten und Tasten tun</translation>
    </message>
    <message>
        <source>Speed: × %1</source>
        <translation>Tempo: × %1</translation>
    </message>
    <message>
        <source>&amp;End Path</source>
        <translation>Weg been&amp;den</translation>
    </message>
    <message>
        <source>Pat&amp;hs</source>
        <translation>&amp;Wege</translation>
    </message>
    <message>
        <source>Show places and paths</source>
        <translation>Orte und Wege zeigen</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>Ma&amp;rken</translation>
    </message>
    <message>
        <source>Show who has which tag by a coloured disc</source>
        <translation>Mit einer farbigen Scheibe zeigen, wer welche Marke hat</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Back to the start, everybody where the scene has them</source>
        <translation>Zurück zum Anfang, alle dort, wo die Szene sie hat</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>Play faster, up to 8 times</source>
        <translation>Schneller abspielen, bis achtfach</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Play slower, down to a tenth</source>
        <translation>Langsamer abspielen, bis zu einem Zehntel</translation>
    </message>
    <message>
        <source>&amp;Keep Pose</source>
        <translation>Haltung &amp;behalten</translation>
    </message>
    <message>
        <source>Put everybody in the scene where they are now</source>
        <translation>Alle in der Szene dorthin stellen, wo sie jetzt sind</translation>
    </message>
    <message>
        <source>&amp;Welcome Page</source>
        <translation>&amp;Willkommensseite</translation>
    </message>
    <message>
        <source>Ready-made scenes, new scenes, and what was open before</source>
        <translation>Fertige Szenen, neue Szenen und was zuletzt offen war</translation>
    </message>
    <message>
        <source>Paint places on the ground that make a path</source>
        <translation>Orte auf den Boden malen, die einen Weg ergeben</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>&amp;Weg</translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation>&amp;Gehen</translation>
    </message>
    <message>
        <source>En&amp;vironment</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>Ereigni&amp;s</translation>
    </message>
    <message>
        <source>&amp;Tag</source>
        <translation>&amp;Marke</translation>
    </message>
    <message>
        <source>&amp;Untag</source>
        <translation>Marke ne&amp;hmen</translation>
    </message>
    <message>
        <source>R&amp;ecord Script</source>
        <translation>Skript auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>Write down as Python what is done by hand from now on</source>
        <translation>Ab jetzt als Python aufschreiben, was von Hand getan wird</translation>
    </message>
    <message>
        <source>Paint with a brush that a script brought along</source>
        <translation>Mit einem Pinsel malen, den ein Skript mitgebracht hat</translation>
    </message>
    <message>
        <source>Scr&amp;ipt</source>
        <translation>Skri&amp;pt</translation>
    </message>
    <message>
        <source>Paint obstacles, attractors, exits, slow, forbidden and liked ground</source>
        <translation>Hindernisse, Anziehungspunkte, Ausgänge, langsamen, verbotenen und beliebten Boden malen</translation>
    </message>
    <message>
        <source>Walking St&amp;yle</source>
        <translation>Gangar&amp;t</translation>
    </message>
    <message>
        <source>One step, then pause</source>
        <translation>Einen Schritt, dann Pause</translation>
    </message>
    <message>
        <source>Path That &amp;Ends at the Last Place</source>
        <translation>Weg, der am letzten Ort &amp;endet</translation>
    </message>
    <message>
        <source>Path Going &amp;Round and Round</source>
        <translation>Weg, der immer im &amp;Kreis führt</translation>
    </message>
    <message>
        <source>A path over the selected places, and on to the first one</source>
        <translation>Ein Weg über die gewählten Orte und weiter zum ersten</translation>
    </message>
    <message>
        <source>Path &amp;Jumping to the First Place</source>
        <translation>Weg, der zum ersten Ort &amp;springt</translation>
    </message>
    <message>
        <source>Add from &amp;Library…</source>
        <translation>Aus Bibliothek &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>Choose built-in characters to paint with</source>
        <translation>Mitgelieferte Figuren zum Malen wählen</translation>
    </message>
    <message>
        <source>&amp;Import Templates…</source>
        <translation>&amp;Vorlagen importieren …</translation>
    </message>
    <message>
        <source>Remove the selected characters</source>
        <translation>Die ausgewählten Figuren entfernen</translation>
    </message>
    <message>
        <source>Put on the &amp;Ground</source>
        <translation>Auf den &amp;Boden stellen</translation>
    </message>
    <message>
        <source>A path over the selected places, in order; characters stop there</source>
        <translation>Ein Weg über die gewählten Orte, der Reihe nach; Figuren bleiben am Ende stehen</translation>
    </message>
    <message>
        <source>A path over the selected places; characters jump from its last place to its first</source>
        <translation>Ein Weg über die gewählten Orte; Figuren springen vom letzten zum ersten</translation>
    </message>
    <message>
        <source>Show the selected characters and places; everything when nothing is selected</source>
        <translation>Die gewählten Figuren und Orte zeigen; alles, wenn nichts gewählt ist</translation>
    </message>
    <message>
        <source>Create characters only on free seats</source>
        <translation>Figuren nur auf freie Sitze setzen</translation>
    </message>
    <message>
        <source>Reset &amp;Brushes</source>
        <translation>Pinsel &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Set all brushes as they were in the beginning</source>
        <translation>Alle Pinsel so einstellen, wie sie am Anfang waren</translation>
    </message>
    <message>
        <source>Select characters, move them, delete them</source>
        <translation>Figuren auswählen, verschieben, löschen</translation>
    </message>
    <message>
        <source>Spray new characters into the scene</source>
        <translation>Neue Figuren in die Szene sprühen</translation>
    </message>
    <message>
        <source>Spray characters away</source>
        <translation>Figuren wegsprühen</translation>
    </message>
    <message>
        <source>Recolour the characters under the brush</source>
        <translation>Die Figuren unter dem Pinsel umfärben</translation>
    </message>
    <message>
        <source>Turn the characters under the brush</source>
        <translation>Die Figuren unter dem Pinsel drehen</translation>
    </message>
    <message>
        <source>Give the characters under the brush another animation</source>
        <translation>Den Figuren unter dem Pinsel eine andere Animation geben</translation>
    </message>
    <message>
        <source>Let the characters under the brush walk along a path</source>
        <translation>Die Figuren unter dem Pinsel einen Weg gehen lassen</translation>
    </message>
    <message>
        <source>Set with which clip and how fast characters walk</source>
        <translation>Festlegen, mit welchem Clip und wie schnell Figuren gehen</translation>
    </message>
    <message>
        <source>Let an event happen to the characters under the brush</source>
        <translation>Den Figuren unter dem Pinsel ein Ereignis zukommen lassen</translation>
    </message>
    <message>
        <source>Tag the characters under the brush, for rules to ask for</source>
        <translation>Die Figuren unter dem Pinsel markieren, damit Regeln danach fragen können</translation>
    </message>
    <message>
        <source>Take a tag off the characters under the brush</source>
        <translation>Den Figuren unter dem Pinsel eine Marke nehmen</translation>
    </message>
    <message>
        <source>Put those of the selected characters, or of all, who stand where nobody can walk on the nearest ground</source>
        <translation>Ausgewählte Figuren, sonst alle, die stehen, wo niemand gehen kann, auf den nächsten Boden stellen</translation>
    </message>
    <message>
        <source>Put all panels back, and show in the picture what was shown at first</source>
        <translation>Alle Tafeln zurückstellen und im Bild zeigen, was am Anfang gezeigt wurde</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Höhe un&amp;d Umfang</translation>
    </message>
    <message>
        <source>Make the characters under the brush taller or stouter</source>
        <translation>Figuren unter dem Pinsel größer oder fülliger machen</translation>
    </message>
    <message>
        <source>Material (te&amp;xtures)</source>
        <translation>Material (Te&amp;xturen)</translation>
    </message>
    <message>
        <source>Give the characters under the brush other materials</source>
        <translation>Figuren unter dem Pinsel andere Materialien geben</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Theme, mouse, autosave, memory, language, shortcuts</source>
        <translation>Farben, Maus, Sicherung, Speicher, Sprache, Tasten</translation>
    </message>
    <message>
        <source>&amp;Group Selected</source>
        <translation>Ausgewählte &amp;gruppieren</translation>
    </message>
    <message>
        <source>A new group of the selected characters; it becomes active</source>
        <translation>Eine neue Gruppe aus den ausgewählten Figuren; sie wird aktiv</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppe</translation>
    </message>
    <message>
        <source>Take the characters under the brush into a group</source>
        <translation>Die Figuren unter dem Pinsel in eine Gruppe nehmen</translation>
    </message>
    <message>
        <source>Select Si&amp;milar</source>
        <translation>Ä&amp;hnliche auswählen</translation>
    </message>
    <message>
        <source>Also those who look like one of the selected: template, materials, colours</source>
        <translation>Auch die, die wie einer der Ausgewählten aussehen: Vorlage, Materialien, Farben</translation>
    </message>
    <message>
        <source>&amp;Grow Selection</source>
        <translation>Auswahl &amp;vergrößern</translation>
    </message>
    <message>
        <source>Also those who stand beside the selected</source>
        <translation>Auch die, die neben den Ausgewählten stehen</translation>
    </message>
    <message>
        <source>Sh&amp;rink Selection</source>
        <translation>Auswahl ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Without those who stand beside somebody not selected</source>
        <translation>Ohne die, die neben nicht Ausgewählten stehen</translation>
    </message>
    <message>
        <source>Select with a &amp;Lasso</source>
        <translation>Mit dem &amp;Lasso auswählen</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Shu&amp;ffle</source>
        <translation>&amp;Mischen</translation>
    </message>
    <message>
        <source>Let the characters under the brush exchange what they have</source>
        <translation>Die Figuren unter dem Pinsel untereinander tauschen lassen, was sie haben</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>Exchange who the characters under the brush are</source>
        <translation>Austauschen, wer die Figuren unter dem Pinsel sind</translation>
    </message>
    <message>
        <source>&amp;Clone</source>
        <translation>&amp;Klonen</translation>
    </message>
    <message>
        <source>Give the characters under the brush what another one has</source>
        <translation>Den Figuren unter dem Pinsel geben, was eine andere hat</translation>
    </message>
    <message>
        <source>&amp;Parts</source>
        <translation>&amp;Teile</translation>
    </message>
    <message>
        <source>Show or hide hats, bags and other parts</source>
        <translation>Hüte, Taschen und andere Teile zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>&amp;Schieben</translation>
    </message>
    <message>
        <source>Push, gather, spread or comb the characters</source>
        <translation>Figuren schieben, sammeln, verteilen oder kämmen</translation>
    </message>
    <message>
        <source>Sm&amp;ooth</source>
        <translation>&amp;Glätten</translation>
    </message>
    <message>
        <source>Let the characters under the brush become like their neighbours</source>
        <translation>Die Figuren unter dem Pinsel ihren Nachbarn angleichen</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>&amp;Zeit</translation>
    </message>
    <message>
        <source>Let the characters under the brush begin sooner or later: waves</source>
        <translation>Die Figuren unter dem Pinsel früher oder später beginnen lassen: Wellen</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern …</translation>
    </message>
    <message>
        <source>Save the view as a picture, in any size</source>
        <translation>Die Ansicht als Bild speichern, in beliebiger Größe</translation>
    </message>
    <message>
        <source>Give the characters under the brush back what they had</source>
        <translation>Den Figuren unter dem Pinsel zurückgeben, was sie hatten</translation>
    </message>
    <message>
        <source>&amp;Walkable Ground</source>
        <translation>Be&amp;gehbarer Boden</translation>
    </message>
    <message>
        <source>Show where characters can walk by a colour on the ground</source>
        <translation>Zeigt durch eine Farbe auf dem Boden, wo Figuren gehen können</translation>
    </message>
    <message>
        <source>&amp;Rules and Cues</source>
        <translation>&amp;Regeln und Stichworte</translation>
    </message>
    <message>
        <source>Show the panel of what characters do when, and of its cues</source>
        <translation>Zeigt das Bedienfeld mit dem, was Figuren wann tun, und seinen Stichworten</translation>
    </message>
    <message>
        <source>Recall State &amp;1</source>
        <translation>Zustand &amp;1 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;1</source>
        <translation>Zustand &amp;1 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;2</source>
        <translation>Zustand &amp;2 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;2</source>
        <translation>Zustand &amp;2 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;3</source>
        <translation>Zustand &amp;3 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;3</source>
        <translation>Zustand &amp;3 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;4</source>
        <translation>Zustand &amp;4 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;4</source>
        <translation>Zustand &amp;4 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;5</source>
        <translation>Zustand &amp;5 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;5</source>
        <translation>Zustand &amp;5 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;6</source>
        <translation>Zustand &amp;6 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;6</source>
        <translation>Zustand &amp;6 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;7</source>
        <translation>Zustand &amp;7 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;7</source>
        <translation>Zustand &amp;7 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;8</source>
        <translation>Zustand &amp;8 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;8</source>
        <translation>Zustand &amp;8 merken</translation>
    </message>
    <message>
        <source>Recall State &amp;9</source>
        <translation>Zustand &amp;9 abrufen</translation>
    </message>
    <message>
        <source>Keep State &amp;9</source>
        <translation>Zustand &amp;9 merken</translation>
    </message>
    <message>
        <source>Keep how the crowd is now, or who is selected, as the state of this number</source>
        <translation>Wie die Menge jetzt ist, oder die Ausgewählten, als Zustand mit dieser Nummer merken</translation>
    </message>
    <message>
        <source>Give everybody back what he had in the state of this number: while it plays in this run alone, else in the scene</source>
        <translation>Allen zurückgeben, was sie im Zustand dieser Nummer hatten: beim Abspielen nur in diesem Lauf, sonst in der Szene</translation>
    </message>
    <message>
        <source>&amp;Emotion</source>
        <translation>&amp;Stimmung</translation>
    </message>
    <message>
        <source>Paint how the characters under the brush feel, or another feature</source>
        <translation>Malt, wie den Figuren unter dem Pinsel zumute ist, oder ein anderes Merkmal</translation>
    </message>
    <message>
        <source>&amp;Outfit</source>
        <translation>&amp;Kleidung</translation>
    </message>
    <message>
        <source>Dress the characters under the brush</source>
        <translation>Kleidet die Figuren unter dem Pinsel ein</translation>
    </message>
    <message>
        <source>Grow to R&amp;elated</source>
        <translation>Auf &amp;Verbundene erweitern</translation>
    </message>
    <message>
        <source>Select also those who are related to one of the selected</source>
        <translation>Auch die auswählen, die mit einem der Ausgewählten verbunden sind</translation>
    </message>
    <message>
        <source>D&amp;uplicate Selected</source>
        <translation>Ausgewählte d&amp;uplizieren</translation>
    </message>
    <message>
        <source>Copy the selected characters beside themselves, with the relations among them</source>
        <translation>Die ausgewählten Figuren neben sich kopieren, mit den Beziehungen untereinander</translation>
    </message>
    <message>
        <source>&amp;Relations</source>
        <translation>Be&amp;ziehungen</translation>
    </message>
    <message>
        <source>Show by arcs to whom the selected are related; all of them where nobody is selected</source>
        <translation>Mit Bögen zeigen, mit wem die Ausgewählten verbunden sind; alle, wo niemand ausgewählt ist</translation>
    </message>
    <message>
        <source>Re&amp;lation</source>
        <translation>Be&amp;ziehung</translation>
    </message>
    <message>
        <source>Relate characters: friends, families, couples, leaders</source>
        <translation>Figuren verbinden: Freunde, Familien, Paare, Anführer</translation>
    </message>
    <message>
        <source>&amp;Quick Reference Card</source>
        <translation>&amp;Kurzübersicht</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Show the shadows of people and stages</source>
        <translation>Die Schatten von Figuren und Bühnen zeigen</translation>
    </message>
    <message>
        <source>“%1” was recalled in this run alone: Stop gives the scene back. Undo once more takes back: %2</source>
        <translation>„%1“ wurde nur in diesem Lauf abgerufen: Anhalten gibt die Szene zurück. Nochmals rückgängig nimmt zurück: %2</translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>Everybody as they were one step before, then pause</source>
        <translation>Alle, wie sie einen Schritt vorher waren, dann Pause</translation>
    </message>
    <message>
        <source>&amp;Latest Moment</source>
        <translation>&amp;Neuester Augenblick</translation>
    </message>
    <message>
        <source>From an earlier moment back to where the run has come</source>
        <translation>Von einem früheren Augenblick dorthin, wie weit der Lauf gekommen ist</translation>
    </message>
    <message>
        <source>Make Mo&amp;vie…</source>
        <translation>&amp;Film machen …</translation>
    </message>
    <message>
        <source>Write what has been played, or the scene, as a movie</source>
        <translation>Was abgespielt wurde, oder die Szene, als Film schreiben</translation>
    </message>
    <message>
        <source>R&amp;ecord into the Timeline</source>
        <translation>In die Zeitleiste auf&amp;nehmen</translation>
    </message>
    <message>
        <source>Cues, states and events become marks as they are performed</source>
        <translation>Stichwörter, Zustände und Ereignisse werden zu Zeitmarken, wenn sie gegeben werden</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>Zeit&amp;punkt merken</translation>
    </message>
    <message>
        <source>A marker in the timeline at this moment</source>
        <translation>Eine Zeitmarke in der Zeitleiste für diesen Augenblick</translation>
    </message>
    <message>
        <source>Former Mar&amp;k</source>
        <translation>&amp;Vorige Zeitmarke</translation>
    </message>
    <message>
        <source>Show the moment of the mark before this one</source>
        <translation>Den Augenblick der Zeitmarke vor diesem zeigen</translation>
    </message>
    <message>
        <source>&amp;Next Mark</source>
        <translation>Nä&amp;chste Zeitmarke</translation>
    </message>
    <message>
        <source>Show the moment of the mark after this one</source>
        <translation>Den Augenblick der Zeitmarke nach diesem zeigen</translation>
    </message>
    <message>
        <source>Time&amp;line</source>
        <translation>&amp;Zeitleiste</translation>
    </message>
    <message>
        <source>Show the panel of what happens when while it plays</source>
        <translation>Das Bedienfeld zeigen, in dem steht, was wann geschieht, während es läuft</translation>
    </message>
    <message>
        <source>Play &amp;from Here On</source>
        <translation>Ab &amp;hier abspielen</translation>
    </message>
    <message>
        <source>What is played begins at this moment</source>
        <translation>Was abgespielt wird, beginnt in diesem Augenblick</translation>
    </message>
    <message>
        <source>Play &amp;until Here</source>
        <translation>B&amp;is hier abspielen</translation>
    </message>
    <message>
        <source>What is played ends at this moment</source>
        <translation>Was abgespielt wird, endet in diesem Augenblick</translation>
    </message>
    <message>
        <source>Play &amp;All Time</source>
        <translation>Die gan&amp;ze Zeit abspielen</translation>
    </message>
    <message>
        <source>Play neither begins nor ends early</source>
        <translation>Das Abspielen beginnt nicht später und endet nicht früher</translation>
    </message>
    <message>
        <source>Play &amp;Over and Over</source>
        <translation>I&amp;mmer wieder abspielen</translation>
    </message>
    <message>
        <source>At the end of what is played it begins again</source>
        <translation>Am Ende dessen, was abgespielt wird, beginnt es von vorn</translation>
    </message>
    <message>
        <source>Show the Be&amp;ginning</source>
        <translation>Den An&amp;fang zeigen</translation>
    </message>
    <message>
        <source>The first moment of what is played, or has been</source>
        <translation>Der erste Augenblick dessen, was abgespielt wird oder wurde</translation>
    </message>
    <message>
        <source>Show the &amp;End</source>
        <translation>Das En&amp;de zeigen</translation>
    </message>
    <message>
        <source>The last moment of what is played, or has been</source>
        <translation>Der letzte Augenblick dessen, was abgespielt wird oder wurde</translation>
    </message>
    <message>
        <source>Take It from &amp;Here</source>
        <translation>Von &amp;hier an neu</translation>
    </message>
    <message>
        <source>&amp;Camera as Now</source>
        <translation>&amp;Kamera wie jetzt</translation>
    </message>
    <message>
        <source>From this moment of the timeline on the camera looks as the view does now</source>
        <translation>Von diesem Augenblick der Zeitleiste an sieht die Kamera, was die Ansicht jetzt zeigt</translation>
    </message>
    <message>
        <source>Follow the T&amp;imeline</source>
        <translation>Der Ze&amp;itleiste folgen</translation>
    </message>
    <message>
        <source>The view looks through the timeline&apos;s camera, where there is one</source>
        <translation>Die Ansicht blickt durch die Kamera der Zeitleiste, wo es eine gibt</translation>
    </message>
    <message>
        <source>Keep Ta&amp;ke</source>
        <translation>Ta&amp;ke behalten</translation>
    </message>
    <message>
        <source>Keep what has been played, to be shown again as it was</source>
        <translation>Behält, was gespielt wurde, um es wieder zu zeigen, wie es war</translation>
    </message>
    <message>
        <source>R&amp;etake Selected</source>
        <translation>Gewählte n&amp;eu spielen lassen</translation>
    </message>
    <message>
        <source>In a take, they do something else in the play range, or from the moment shown on; everybody else does what he did</source>
        <translation>In einem Take tun sie im Abspielbereich, sonst vom gezeigten Augenblick an, etwas anderes; alle anderen tun, was sie taten</translation>
    </message>
    <message>
        <source>Show Ne&amp;xt Take</source>
        <translation>Nä&amp;chsten Take zeigen</translation>
    </message>
    <message>
        <source>One take after the other, then the scene as it plays</source>
        <translation>Ein Take nach dem anderen, dann die Szene, wie sie spielt</translation>
    </message>
    <message>
        <source>Ta&amp;kes</source>
        <translation>Ta&amp;kes</translation>
    </message>
    <message>
        <source>Runs that were kept: show, compare, take parts again</source>
        <translation>Behaltene Läufe: zeigen, vergleichen, Teile neu spielen</translation>
    </message>
    <message>
        <source>Reta&amp;ke</source>
        <translation>&amp;Neu spielen lassen</translation>
    </message>
    <message>
        <source>Let the characters under the brush do it again while all others do what they did in the take</source>
        <translation>Die Figuren unter dem Pinsel neu spielen lassen, während alle anderen tun, was sie im Take taten</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>Type the name of an action, a brush, a panel or a setting</source>
        <translation>Den Namen einer Aktion, eines Pinsels, eines Bedienfelds oder einer Einstellung eingeben</translation>
    </message>
    <message>
        <source>The run goes on from the moment shown, and what came after it is forgotten; out of a take another run goes on from there</source>
        <translation>Der Lauf geht vom gezeigten Augenblick an weiter, und was danach kam, ist vergessen; aus einem Take heraus geht ein anderer Lauf von dort an weiter</translation>
    </message>
    <message>
        <source>Draw a line round those to select, or to paint with a brush; else a rectangle, or a circle</source>
        <translation>Eine Linie um die ziehen, die ausgewählt oder mit einem Pinsel bemalt werden sollen; sonst ein Rechteck oder ein Kreis</translation>
    </message>
    <message numerus="yes">
        <source>Undone: %n short stroke(s)</source>
        <translation>
            <numerusform>Rückgängig gemacht: %n kurzer Strich</numerusform>
            <numerusform>Rückgängig gemacht: %n kurze Striche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done again: %n short stroke(s)</source>
        <translation>
            <numerusform>Wieder ausgeführt: %n kurzer Strich</numerusform>
            <numerusform>Wieder ausgeführt: %n kurze Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>End the path, line or area that is being drawn</source>
        <translation>Den Weg, die Linie oder die Fläche beenden, die gerade gezeichnet wird</translation>
    </message>
</context>
<context>
    <name>BrushStart</name>
    <message>
        <source>Click the character that the others are to be like</source>
        <translation>Die Figur anklicken, der die anderen gleichen sollen</translation>
    </message>
    <message>
        <source>The first stroke makes a new group</source>
        <translation>Der erste Strich legt eine neue Gruppe an</translation>
    </message>
    <message>
        <source>No group is chosen: strokes take characters out of theirs</source>
        <translation>Keine Gruppe ist gewählt: Striche nehmen Figuren aus ihrer heraus</translation>
    </message>
    <message>
        <source>No script has brought a brush along yet: run one in the Python console</source>
        <translation>Noch kein Skript hat einen Pinsel mitgebracht: in der Python-Konsole eines ausführen</translation>
    </message>
    <message>
        <source>Choose in the settings which templates characters become</source>
        <translation>In den Einstellungen wählen, zu welchen Vorlagen Figuren werden</translation>
    </message>
    <message>
        <source>Choose in the settings which state characters get back</source>
        <translation>In den Einstellungen wählen, welchen Zustand Figuren zurückbekommen</translation>
    </message>
    <message>
        <source>No take is shown: keep what was played, then choose it in the Takes panel</source>
        <translation>Es wird kein Take gezeigt: Behalten Sie, was gespielt wurde, und wählen Sie es dann im Bedienfeld Takes</translation>
    </message>
</context>
<context>
    <name>BrushTexts</name>
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
    <message>
        <source>Distance, m</source>
        <translation>Abstand, m</translation>
    </message>
    <message>
        <source>Of them, %</source>
        <translation>Davon, %</translation>
    </message>
    <message>
        <source>Turned by, °</source>
        <translation>Gedreht um, °</translation>
    </message>
    <message>
        <source>Distance: %1 m</source>
        <translation>Abstand: %1 m</translation>
    </message>
    <message>
        <source>Delete: %1 % of them</source>
        <translation>Löschen: %1 % davon</translation>
    </message>
    <message>
        <source>Turned by: %1°</source>
        <translation>Gedreht um: %1°</translation>
    </message>
    <message>
        <source>Walking speed, m/s</source>
        <translation>Gehtempo, m/s</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Radius, m</source>
        <translation>Radius, m</translation>
    </message>
    <message>
        <source>Walking speed: %1 m/s</source>
        <translation>Gehtempo: %1 m/s</translation>
    </message>
    <message>
        <source>Tag: %1</source>
        <translation>Marke: %1</translation>
    </message>
    <message>
        <source>Number: %1</source>
        <translation>Zahl: %1</translation>
    </message>
    <message>
        <source>Radius: %1 m</source>
        <translation>Radius: %1 m</translation>
    </message>
    <message>
        <source>Characters per m²</source>
        <translation>Figuren je m²</translation>
    </message>
    <message>
        <source>Density: %1 characters per m²</source>
        <translation>Dichte: %1 Figuren je m²</translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height: × %1</source>
        <translation>Höhe: × %1</translation>
    </message>
    <message>
        <source>Speed of the wave, m/s</source>
        <translation>Tempo der Welle, m/s</translation>
    </message>
    <message>
        <source>Wave: %1 m/s</source>
        <translation>Welle: %1 m/s</translation>
    </message>
    <message>
        <source>Delay, s</source>
        <translation>Verzögerung, s</translation>
    </message>
    <message>
        <source>Delay: %1 s</source>
        <translation>Verzögerung: %1 s</translation>
    </message>
    <message>
        <source>Width, m</source>
        <translation>Breite, m</translation>
    </message>
    <message>
        <source>Width: %1 m</source>
        <translation>Breite: %1 m</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>The stroke was taken back.</source>
        <translation>Der Strich wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Left: point · Middle: circle · Right: rectangle · Alt or Space and drag: navigate · [ ]: size</source>
        <translation>Links: Punkt · Mitte: Kreis · Rechts: Rechteck · Alt oder Leertaste und ziehen: navigieren · [ ]: Größe</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Click somebody to take the colour · Escape: not now</source>
        <translation>Jemanden anklicken, um die Farbe zu nehmen · Esc: jetzt nicht</translation>
    </message>
    <message>
        <source>Click the point to face · Escape: not now</source>
        <translation>Den Punkt anklicken, zu dem sie sehen · Esc: jetzt nicht</translation>
    </message>
    <message>
        <source>Nobody under the cursor</source>
        <translation>Niemand unter dem Zeiger</translation>
    </message>
    <message>
        <source>Right button: brushes · Alt or Space and drag: navigate · [ ]: size</source>
        <translation>Rechte Taste: Pinsel · Alt oder Leertaste und ziehen: bewegen · [ ]: Größe</translation>
    </message>
    <message>
        <source>No script brush is there yet: a script brings one along with crowdbrush.register_brush.</source>
        <translation>Noch ist kein Skriptpinsel da: Ein Skript bringt einen mit crowdbrush.register_brush mit.</translation>
    </message>
    <message numerus="yes">
        <source>%n characters created</source>
        <translation>
            <numerusform>%n Figur erschaffen</numerusform>
            <numerusform>%n Figuren erschaffen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters deleted</source>
        <translation>
            <numerusform>%n Figur gelöscht</numerusform>
            <numerusform>%n Figuren gelöscht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters coloured</source>
        <translation>
            <numerusform>%n Figur gefärbt</numerusform>
            <numerusform>%n Figuren gefärbt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters turned</source>
        <translation>
            <numerusform>%n Figur gedreht</numerusform>
            <numerusform>%n Figuren gedreht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters walk differently</source>
        <translation>
            <numerusform>Eine Figur geht anders</numerusform>
            <numerusform>%n Figuren gehen anders</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters walk in another way</source>
        <translation>
            <numerusform>Eine Figur geht anders</numerusform>
            <numerusform>%n Figuren gehen anders</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters tagged</source>
        <translation>
            <numerusform>Eine Figur markiert</numerusform>
            <numerusform>%n Figuren markiert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters without the tag</source>
        <translation>
            <numerusform>Eine Figur ohne die Marke</numerusform>
            <numerusform>%n Figuren ohne die Marke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters heard it</source>
        <translation>
            <numerusform>Eine Figur hat es gehört</numerusform>
            <numerusform>%n Figuren haben es gehört</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters changed</source>
        <translation>
            <numerusform>Eine Figur geändert</numerusform>
            <numerusform>%n Figuren geändert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: create characters · + −: how many · Ctrl+click: more of the kind</source>
        <translation>Ziehen: Figuren erschaffen · + −: wie viele · Strg+Klick: mehr von dieser Art</translation>
    </message>
    <message>
        <source>Drag: delete characters · + −: how fast</source>
        <translation>Ziehen: Figuren löschen · + −: wie schnell</translation>
    </message>
    <message>
        <source>Drag: colour characters · + −: strength · Ctrl+click: take the colour</source>
        <translation>Ziehen: Figuren färben · + −: Stärke · Strg+Klick: die Farbe nehmen</translation>
    </message>
    <message>
        <source>Drag: turn characters · + −: direction · Ctrl+click: the point to face</source>
        <translation>Ziehen: Figuren drehen · + −: Richtung · Strg+Klick: der Punkt, zu dem sie sehen</translation>
    </message>
    <message>
        <source>Drag: change what characters do · + −: speed · Ctrl+click: take the clip</source>
        <translation>Ziehen: ändern, was Figuren tun · + −: Tempo · Strg+Klick: den Clip nehmen</translation>
    </message>
    <message>
        <source>Drag: let characters walk along the path · + −: walking speed</source>
        <translation>Ziehen: Figuren den Weg gehen lassen · + −: Gehtempo</translation>
    </message>
    <message>
        <source>Drag: set how characters walk and how fast · + −: speed</source>
        <translation>Ziehen: festlegen, wie und wie schnell Figuren gehen · + −: Tempo</translation>
    </message>
    <message>
        <source>Drag: tag characters · + −: which tag</source>
        <translation>Ziehen: Figuren markieren · + −: welche Marke</translation>
    </message>
    <message>
        <source>Drag: take the tag off characters · + −: which tag</source>
        <translation>Ziehen: Figuren die Marke nehmen · + −: welche Marke</translation>
    </message>
    <message>
        <source>Drag: let an event happen to characters · + −: its number</source>
        <translation>Ziehen: Figuren ein Ereignis zukommen lassen · + −: seine Zahl</translation>
    </message>
    <message>
        <source>Drag: let the script change characters · Escape: take it back</source>
        <translation>Ziehen: das Skript Figuren ändern lassen · Esc: zurücknehmen</translation>
    </message>
    <message>
        <source>Drag: scale characters · + −: how tall</source>
        <translation>Ziehen: Größe der Figuren ändern · + −: wie groß</translation>
    </message>
    <message numerus="yes">
        <source>%n characters scaled</source>
        <translation>
            <numerusform>%n Figur in der Größe geändert</numerusform>
            <numerusform>%n Figuren in der Größe geändert</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give characters other materials</source>
        <translation>Ziehen: Figuren andere Materialien geben</translation>
    </message>
    <message numerus="yes">
        <source>%n characters given another material</source>
        <translation>
            <numerusform>%n Figur mit anderem Material</numerusform>
            <numerusform>%n Figuren mit anderem Material</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: take characters into the group</source>
        <translation>Ziehen: Figuren in die Gruppe nehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters taken into the group</source>
        <translation>
            <numerusform>%n Figur in die Gruppe genommen</numerusform>
            <numerusform>%n Figuren in die Gruppe genommen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters restored</source>
        <translation>
            <numerusform>%n Figur wiederhergestellt</numerusform>
            <numerusform>%n Figuren wiederhergestellt</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: let characters exchange what they have</source>
        <translation>Ziehen: Figuren untereinander tauschen lassen, was sie haben</translation>
    </message>
    <message numerus="yes">
        <source>%n characters shuffled</source>
        <translation>
            <numerusform>%n Figur gemischt</numerusform>
            <numerusform>%n Figuren gemischt</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give characters another template</source>
        <translation>Ziehen: Figuren eine andere Vorlage geben</translation>
    </message>
    <message numerus="yes">
        <source>%n characters given another template</source>
        <translation>
            <numerusform>%n Figur hat eine andere Vorlage</numerusform>
            <numerusform>%n Figuren haben eine andere Vorlage</numerusform>
        </translation>
    </message>
    <message>
        <source>Ctrl+click: whom to clone · Drag: give characters what that one has</source>
        <translation>Strg+Klick: wen klonen · Ziehen: Figuren geben, was diese hat</translation>
    </message>
    <message numerus="yes">
        <source>%n characters made alike</source>
        <translation>
            <numerusform>%n Figur angeglichen</numerusform>
            <numerusform>%n Figuren angeglichen</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: show or hide parts of characters</source>
        <translation>Ziehen: Teile von Figuren zeigen oder verbergen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters given other parts</source>
        <translation>
            <numerusform>%n Figur hat andere Teile</numerusform>
            <numerusform>%n Figuren haben andere Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: push characters about</source>
        <translation>Ziehen: Figuren umherschieben</translation>
    </message>
    <message numerus="yes">
        <source>%n characters pushed</source>
        <translation>
            <numerusform>%n Figur verschoben</numerusform>
            <numerusform>%n Figuren verschoben</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: let characters become like their neighbours</source>
        <translation>Ziehen: Figuren ihren Nachbarn angleichen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters smoothed</source>
        <translation>
            <numerusform>%n Figur geglättet</numerusform>
            <numerusform>%n Figuren geglättet</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: set when characters begin · + −: seconds, or the wave&apos;s speed</source>
        <translation>Ziehen: bestimmen, wann Figuren beginnen · + −: Sekunden oder das Tempo der Welle</translation>
    </message>
    <message numerus="yes">
        <source>%n characters begin at another time</source>
        <translation>
            <numerusform>%n Figur beginnt zu anderer Zeit</numerusform>
            <numerusform>%n Figuren beginnen zu anderer Zeit</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · Ctrl+click: take it from somebody</source>
        <translation>%1 · Strg+Klick: von jemandem übernehmen</translation>
    </message>
    <message>
        <source>Click somebody to set the brush by · Escape: not now</source>
        <translation>Auf jemanden klicken, um den Pinsel danach einzustellen · Escape: jetzt nicht</translation>
    </message>
    <message>
        <source>Nothing to take there for this brush</source>
        <translation>Dort gibt es für diesen Pinsel nichts zu übernehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters move differently</source>
        <translation>
            <numerusform>%n Figur bewegt sich anders</numerusform>
            <numerusform>%n Figuren bewegen sich anders</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag: give back what they had</source>
        <translation>Ziehen: zurückgeben, was sie hatten</translation>
    </message>
    <message>
        <source>Drag: paint what characters are like · Ctrl+click: take it</source>
        <translation>Ziehen: malen, wie Figuren sind · Strg+Klick: übernehmen</translation>
    </message>
    <message>
        <source>Drag: dress characters · Ctrl+click: take the outfit</source>
        <translation>Ziehen: Figuren einkleiden · Strg+Klick: Kleidung übernehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters dressed</source>
        <translation>
            <numerusform>%n Figur anders gekleidet</numerusform>
            <numerusform>%n Figuren anders gekleidet</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag from one to another: relate them · Ctrl+drag: take it away</source>
        <translation>Von einer Figur zur anderen ziehen: sie verbinden · Strg+Ziehen: Verbindung lösen</translation>
    </message>
    <message numerus="yes">
        <source>Feature of %n characters changed</source>
        <translation>
            <numerusform>Merkmal von %n Figur geändert</numerusform>
            <numerusform>Merkmal von %n Figuren geändert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Relations of %n characters changed</source>
        <translation>
            <numerusform>Beziehungen von %n Figur geändert</numerusform>
            <numerusform>Beziehungen von %n Figuren geändert</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken: %1</source>
        <translation>Übernommen: %1</translation>
    </message>
    <message>
        <source>Drag: choose who does it again; they begin when you let go</source>
        <translation>Ziehen: wählen, wer neu spielt; sie beginnen beim Loslassen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters do it again…</source>
        <translation>
            <numerusform>%n Figur spielt neu …</numerusform>
            <numerusform>%n Figuren spielen neu …</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken: %1. The other characters are not ticked any more.</source>
        <translation>Übernommen: %1. Die anderen Figuren sind nicht mehr angekreuzt.</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
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
        <translation>Zuerst eine Vorlage zum Erschaffen wählen</translation>
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
    <message>
        <source>No free seat of the chosen rows and wedges under the brush</source>
        <translation>Kein freier Sitz der gewählten Reihen und Keile unter dem Pinsel</translation>
    </message>
    <message>
        <source>So small a share of them is nobody</source>
        <translation>Ein so kleiner Anteil davon ist niemand</translation>
    </message>
    <message>
        <source>All of them already walk like this</source>
        <translation>Alle gehen schon so</translation>
    </message>
    <message>
        <source>All of them already have this tag</source>
        <translation>Alle haben diese Marke schon</translation>
    </message>
    <message>
        <source>None of them has this tag</source>
        <translation>Niemand davon hat diese Marke</translation>
    </message>
    <message>
        <source>The script brush changed nothing</source>
        <translation>Der Skriptpinsel hat nichts geändert</translation>
    </message>
    <message numerus="yes">
        <source>Create %n character(s)</source>
        <translation>
            <numerusform>%n Figur erschaffen</numerusform>
            <numerusform>%n Figuren erschaffen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n character(s)</source>
        <translation>
            <numerusform>%n Figur löschen</numerusform>
            <numerusform>%n Figuren löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour %n character(s)</source>
        <translation>
            <numerusform>%n Figur färben</numerusform>
            <numerusform>%n Figuren färben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n character(s)</source>
        <translation>
            <numerusform>%n Figur drehen</numerusform>
            <numerusform>%n Figuren drehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Animate %n character(s)</source>
        <translation>
            <numerusform>%n Figur animieren</numerusform>
            <numerusform>%n Figuren animieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Set the walk of %n character(s)</source>
        <translation>
            <numerusform>Gang einer Figur setzen</numerusform>
            <numerusform>Gang von %n Figuren setzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Set how %n character(s) walk</source>
        <translation>
            <numerusform>Gangart einer Figur festlegen</numerusform>
            <numerusform>Gangart von %n Figuren festlegen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tag %n character(s)</source>
        <translation>
            <numerusform>Eine Figur markieren</numerusform>
            <numerusform>%n Figuren markieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Untag %n character(s)</source>
        <translation>
            <numerusform>Einer Figur die Marke nehmen</numerusform>
            <numerusform>%n Figuren die Marke nehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Event reached %n character(s)</source>
        <translation>
            <numerusform>Ereignis erreichte eine Figur</numerusform>
            <numerusform>Ereignis erreichte %n Figuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n character(s)</source>
        <translation>
            <numerusform>%1: eine Figur</numerusform>
            <numerusform>%1: %n Figuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n character(s)</source>
        <translation>
            <numerusform>%n Figur verschieben</numerusform>
            <numerusform>%n Figuren verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing runs that could hear an event: give the scene rules, or characters a path, and press Play</source>
        <translation>Nichts läuft, das ein Ereignis hören könnte: Der Szene Regeln oder Figuren einen Weg geben und auf Abspielen drücken</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n character(s)</source>
        <translation>
            <numerusform>Größe von %n Figur ändern</numerusform>
            <numerusform>Größe von %n Figuren ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this size</source>
        <translation>Alle haben diese Größe schon</translation>
    </message>
    <message numerus="yes">
        <source>Give %n character(s) another material</source>
        <translation>
            <numerusform>Material von %n Figur ändern</numerusform>
            <numerusform>Material von %n Figuren ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this material</source>
        <translation>Alle haben dieses Material schon</translation>
    </message>
    <message numerus="yes">
        <source>Take %n character(s) into a group</source>
        <translation>
            <numerusform>%n Figur in eine Gruppe nehmen</numerusform>
            <numerusform>%n Figuren in eine Gruppe nehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are in this group</source>
        <translation>Alle sind schon in dieser Gruppe</translation>
    </message>
    <message>
        <source>The mask of the brush leaves all of them out</source>
        <translation>Die Maske des Pinsels lässt sie alle aus</translation>
    </message>
    <message>
        <source>The group is locked or hidden: the Groups panel shows it</source>
        <translation>Die Gruppe ist gesperrt oder ausgeblendet: Das Bedienfeld „Gruppen“ zeigt es</translation>
    </message>
    <message numerus="yes">
        <source>Restore %n character(s)</source>
        <translation>
            <numerusform>%n Figur wiederherstellen</numerusform>
            <numerusform>%n Figuren wiederherstellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Shuffle %n character(s)</source>
        <translation>
            <numerusform>%n Figur mischen</numerusform>
            <numerusform>%n Figuren mischen</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them have the same</source>
        <translation>Alle haben dasselbe</translation>
    </message>
    <message numerus="yes">
        <source>Give %n character(s) another template</source>
        <translation>
            <numerusform>%n Figur eine andere Vorlage geben</numerusform>
            <numerusform>%n Figuren eine andere Vorlage geben</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already have this template</source>
        <translation>Alle haben diese Vorlage schon</translation>
    </message>
    <message numerus="yes">
        <source>Make %n character(s) alike</source>
        <translation>
            <numerusform>%n Figur angleichen</numerusform>
            <numerusform>%n Figuren angleichen</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them are like that already</source>
        <translation>Alle sind schon so</translation>
    </message>
    <message numerus="yes">
        <source>Change the parts of %n character(s)</source>
        <translation>
            <numerusform>Teile von %n Figur ändern</numerusform>
            <numerusform>Teile von %n Figuren ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are like that</source>
        <translation>Alle sind schon so</translation>
    </message>
    <message numerus="yes">
        <source>Push %n character(s)</source>
        <translation>
            <numerusform>%n Figur verschieben</numerusform>
            <numerusform>%n Figuren verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no room to push them</source>
        <translation>Es ist kein Platz, sie zu verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Smooth %n character(s)</source>
        <translation>
            <numerusform>%n Figur glätten</numerusform>
            <numerusform>%n Figuren glätten</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them are like their neighbours</source>
        <translation>Alle sind schon wie ihre Nachbarn</translation>
    </message>
    <message numerus="yes">
        <source>Set the time of %n character(s)</source>
        <translation>
            <numerusform>Zeit von %n Figur setzen</numerusform>
            <numerusform>Zeit von %n Figuren setzen</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already begin then</source>
        <translation>Alle beginnen schon dann</translation>
    </message>
    <message>
        <source>Ctrl+click somebody to choose first</source>
        <translation>Erst jemanden mit Strg+Klick wählen</translation>
    </message>
    <message>
        <source>None of them has the chosen part</source>
        <translation>Keine von ihnen hat das gewählte Teil</translation>
    </message>
    <message>
        <source>All of them sit: who sits keeps the seat</source>
        <translation>Alle sitzen: Wer sitzt, behält den Platz</translation>
    </message>
    <message>
        <source>None of them has the chosen material</source>
        <translation>Keiner von ihnen hat das gewählte Material</translation>
    </message>
    <message>
        <source>Nobody gets there on foot: raise “Highest step” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation>Dorthin kommt niemand zu Fuß: „Höchste Stufe“ erhöhen (Umgebung, Wo Figuren gehen können), oder im Pinsel „Überall“ wählen</translation>
    </message>
    <message>
        <source>Too steep to walk: raise “Steepest slope” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation>Zu steil zum Gehen: „Steilste Neigung“ erhöhen (Umgebung, Wo Figuren gehen können), oder im Pinsel „Überall“ wählen</translation>
    </message>
    <message>
        <source>Too low to walk under: lower “Body height” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation>Zu niedrig, um darunter zu gehen: „Körpergröße“ verringern (Umgebung, Wo Figuren gehen können), oder im Pinsel „Überall“ wählen</translation>
    </message>
    <message>
        <source>Too near to a wall or an edge: lower “Body radius” (Environment, Where characters can walk), or choose “Anywhere” in the brush settings</source>
        <translation>Zu nah an einer Wand oder Kante: „Körperradius“ verringern (Umgebung, Wo Figuren gehen können), oder im Pinsel „Überall“ wählen</translation>
    </message>
    <message>
        <source>Choose a state in the brush&apos;s settings first</source>
        <translation>Zuerst in den Einstellungen des Pinsels einen Zustand wählen</translation>
    </message>
    <message numerus="yes">
        <source>Paint a feature of %n character(s)</source>
        <translation>
            <numerusform>Merkmal von %n Figur malen</numerusform>
            <numerusform>Merkmal von %n Figuren malen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Dress %n character(s)</source>
        <translation>
            <numerusform>%n Figur einkleiden</numerusform>
            <numerusform>%n Figuren einkleiden</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them already are dressed like that</source>
        <translation>Alle sind schon so gekleidet</translation>
    </message>
    <message>
        <source>The scene has no such feature: choose another kind or value</source>
        <translation>Die Szene hat kein solches Merkmal: ein anderes Merkmal oder einen anderen Wert wählen</translation>
    </message>
    <message>
        <source>The scene has no relation of that name: choose another one</source>
        <translation>Die Szene hat keine Beziehung dieses Namens: eine andere wählen</translation>
    </message>
    <message>
        <source>Drag on to whom they are related</source>
        <translation>Weiterziehen bis zu denen, mit denen sie verbunden werden</translation>
    </message>
    <message>
        <source>None of them has such a relation</source>
        <translation>Keiner von ihnen hat eine solche Beziehung</translation>
    </message>
    <message>
        <source>Those are too many relations at once: take fewer characters</source>
        <translation>Das sind zu viele Beziehungen auf einmal: weniger Figuren nehmen</translation>
    </message>
    <message>
        <source>Now draw around those to whom they are related (Esc: no)</source>
        <translation>Jetzt die umfahren, mit denen sie verbunden werden (Esc: nicht)</translation>
    </message>
    <message numerus="yes">
        <source>Change relations of %n character(s)</source>
        <translation>
            <numerusform>Beziehungen von %n Figur ändern</numerusform>
            <numerusform>Beziehungen von %n Figuren ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Their relations are like that already</source>
        <translation>Ihre Beziehungen sind schon so</translation>
    </message>
    <message numerus="yes">
        <source>Retake %n character(s)</source>
        <translation>
            <numerusform>%n Figur neu spielen</numerusform>
            <numerusform>%n Figuren neu spielen</numerusform>
        </translation>
    </message>
    <message>
        <source>No take is shown: keep what was played, then choose it in the Takes panel</source>
        <translation>Es wird kein Take gezeigt: Behalten Sie, was gespielt wurde, und wählen Sie es dann im Bedienfeld Takes</translation>
    </message>
    <message>
        <source>Another take is still being made: wait for it</source>
        <translation>Ein anderer Take entsteht noch: Warten Sie, bis er fertig ist</translation>
    </message>
    <message>
        <source>An obstacle or forbidden ground: choose “Anywhere” in the brush settings to create there all the same</source>
        <translation>Ein Hindernis oder verbotener Boden: Wählen Sie „Überall“ in den Pinseleinstellungen, um dort trotzdem zu erzeugen</translation>
    </message>
</context>
<context>
    <name>ClipRole</name>
    <message>
        <source>Idle</source>
        <translation>Stehen</translation>
    </message>
    <message>
        <source>What the character does while it stands</source>
        <translation>Was die Figur tut, während sie steht</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>How it gets on at its usual speed</source>
        <translation>Wie sie in ihrem üblichen Tempo vorankommt</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Laufen</translation>
    </message>
    <message>
        <source>How it gets on when it is in a hurry</source>
        <translation>Wie sie vorankommt, wenn sie es eilig hat</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Fliegen</translation>
    </message>
    <message>
        <source>How it gets on without touching the ground, at the clip&apos;s own pace</source>
        <translation>Wie sie vorankommt, ohne den Boden zu berühren, im Tempo des Clips</translation>
    </message>
    <message>
        <source>Sit</source>
        <translation>Sitzen</translation>
    </message>
    <message>
        <source>What it does on a seat</source>
        <translation>Was sie auf einem Sitz tut</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Played only where a brush or a rule asks for it</source>
        <translation>Wird nur gespielt, wo ein Pinsel oder eine Regel danach verlangt</translation>
    </message>
</context>
<context>
    <name>Cues</name>
    <message>
        <source>Nobody is selected who could hear “%1”.</source>
        <translation>Niemand ist ausgewählt, der „%1“ hören könnte.</translation>
    </message>
    <message>
        <source>Cue: “%1”</source>
        <translation>Stichwort: „%1“</translation>
    </message>
    <message>
        <source>Press Play first: cues speak to characters while it plays.</source>
        <translation>Erst abspielen: Stichworte wirken, während es läuft.</translation>
    </message>
    <message>
        <source>Where characters can walk is still being found: they hear cues from when they begin to move.</source>
        <translation>Es wird noch herausgefunden, wo Figuren gehen können: Stichworte hören sie, sobald sie sich bewegen.</translation>
    </message>
    <message>
        <source>The state that “%1” recalls is not there any more: choose another one.</source>
        <translation>Den Zustand, den „%1“ abruft, gibt es nicht mehr: Wählen Sie einen anderen.</translation>
    </message>
</context>
<context>
    <name>FeatureCommands</name>
    <message>
        <source>It needs a name.</source>
        <translation>Es braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is one of that name already.</source>
        <translation>Den Namen gibt es schon.</translation>
    </message>
    <message>
        <source>There are as many values as there can be.</source>
        <translation>Mehr Werte kann es nicht geben.</translation>
    </message>
    <message>
        <source>Remove a feature</source>
        <translation>Merkmal entfernen</translation>
    </message>
    <message>
        <source>Rename a feature</source>
        <translation>Merkmal umbenennen</translation>
    </message>
    <message>
        <source>Value %1</source>
        <translation>Wert %1</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>Wert hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate a value</source>
        <translation>Wert duplizieren</translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation>Wert entfernen</translation>
    </message>
    <message>
        <source>Rename a value</source>
        <translation>Wert umbenennen</translation>
    </message>
    <message>
        <source>Arrange values</source>
        <translation>Werte ordnen</translation>
    </message>
    <message numerus="yes">
        <source>“%1”: %n characters changed</source>
        <translation>
            <numerusform>„%1“: %n Figur geändert</numerusform>
            <numerusform>„%1“: %n Figuren geändert</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody bears it.</source>
        <translation>Niemand trägt es.</translation>
    </message>
    <message>
        <source>Take features from a file</source>
        <translation>Merkmale aus einer Datei übernehmen</translation>
    </message>
    <message>
        <source>Feature %1</source>
        <translation>Merkmal %1</translation>
    </message>
    <message>
        <source>A scene has at most %1 features: remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Merkmale: erst eines entfernen.</translation>
    </message>
    <message>
        <source>Add a feature</source>
        <translation>Merkmal hinzufügen</translation>
    </message>
    <message>
        <source>Nobody is there yet.</source>
        <translation>Es ist noch niemand da.</translation>
    </message>
    <message>
        <source>Give “%1”</source>
        <translation>„%1“ geben</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone; %n characters had it</source>
        <translation>
            <numerusform>„%1“ ist entfernt; %n Figur hatte es</numerusform>
            <numerusform>„%1“ ist entfernt; %n Figuren hatten es</numerusform>
        </translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone; %n characters had a value of it</source>
        <translation>
            <numerusform>„%1“ ist weg; %n Figur hatte einen Wert davon</numerusform>
            <numerusform>„%1“ ist weg; %n Figuren hatten einen Wert davon</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>“%1” for all, as nobody is selected: %n characters changed</source>
        <translation>
            <numerusform>„%1“ für alle, da niemand ausgewählt ist: %n Figur geändert</numerusform>
            <numerusform>„%1“ für alle, da niemand ausgewählt ist: %n Figuren geändert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>“%1” changed, and %n characters with it</source>
        <translation>
            <numerusform>„%1“ geändert, und %n Figur mit ihm</numerusform>
            <numerusform>„%1“ geändert, und %n Figuren mit ihm</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Features</name>
    <message>
        <source>emotion</source>
        <translation>Stimmung</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>neutral</translation>
    </message>
    <message>
        <source>sad</source>
        <translation>traurig</translation>
    </message>
    <message>
        <source>bored</source>
        <translation>gelangweilt</translation>
    </message>
    <message>
        <source>attentive</source>
        <translation>aufmerksam</translation>
    </message>
    <message>
        <source>happy</source>
        <translation>fröhlich</translation>
    </message>
    <message>
        <source>excited</source>
        <translation>begeistert</translation>
    </message>
    <message>
        <source>angry</source>
        <translation>wütend</translation>
    </message>
    <message>
        <source>everyday</source>
        <translation>Alltag</translation>
    </message>
    <message>
        <source>evening</source>
        <translation>Abend</translation>
    </message>
    <message>
        <source>work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>sport</source>
        <translation>Sport</translation>
    </message>
    <message>
        <source>rain</source>
        <translation>Regen</translation>
    </message>
    <message>
        <source>team red</source>
        <translation>Team Rot</translation>
    </message>
    <message>
        <source>team blue</source>
        <translation>Team Blau</translation>
    </message>
    <message>
        <source>antique rich</source>
        <translation>Antike, reich</translation>
    </message>
    <message>
        <source>antique poor</source>
        <translation>Antike, arm</translation>
    </message>
    <message>
        <source>outfit</source>
        <translation>Kleidung</translation>
    </message>
</context>
<context>
    <name>Fields</name>
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
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
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
        <source>Also characters hidden behind others or the stage</source>
        <translation>Auch Figuren, die von anderen oder der Bühne verdeckt sind</translation>
    </message>
    <message>
        <source>Build up</source>
        <translation>Mehrfach</translation>
    </message>
    <message>
        <source>Each dab changes again whom it touches</source>
        <translation>Jeder Tupfer ändert erneut, wen er berührt</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Pen: size</source>
        <translation>Stift: Größe</translation>
    </message>
    <message>
        <source>The harder the pen presses, the larger</source>
        <translation>Je fester der Stift drückt, desto größer</translation>
    </message>
    <message>
        <source>Pen: rate</source>
        <translation>Stift: Rate</translation>
    </message>
    <message>
        <source>The harder the pen presses, the more</source>
        <translation>Je fester der Stift drückt, desto mehr</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Häufigkeit</translation>
    </message>
    <message>
        <source>How often low (left) to high values (right) come: draw it; a double click makes all equal</source>
        <translation>Wie oft niedrige (links) bis hohe Werte (rechts) vorkommen: zeichnen; ein Doppelklick macht alle gleich</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
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
        <source>Timing</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Change the speed</source>
        <translation>Tempo ändern</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Slot</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Anstrich</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Blend the colours</source>
        <translation>Farben mischen</translation>
    </message>
    <message>
        <source>Also what lies between the colours, not only one of them</source>
        <translation>Auch was zwischen den Farben liegt, nicht nur eine davon</translation>
    </message>
    <message>
        <source>Each slot its own</source>
        <translation>Jeder Slot eigens</translation>
    </message>
    <message>
        <source>Another colour for each slot of a character</source>
        <translation>Eine andere Farbe für jeden Slot einer Figur</translation>
    </message>
    <message>
        <source>Only on free seats</source>
        <translation>Nur auf freie Sitze</translation>
    </message>
    <message>
        <source>Seat grid: characters sit down where they may</source>
        <translation>Sitzraster: Figuren setzen sich, wo sie dürfen</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Rows</source>
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
        <source>Anywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Also on roofs, trees and wherever else nobody can walk to</source>
        <translation>Auch auf Dächern, Bäumen und wo sonst niemand hingehen kann</translation>
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
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Outfits</source>
        <translation>Kleidung</translation>
    </message>
    <message>
        <source>Each wears any of the clothes that the template has</source>
        <translation>Jede Figur trägt irgendetwas von der Kleidung der Vorlage</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Gesichter</translation>
    </message>
    <message>
        <source>Each has any of the skins, faces and hair that the template has</source>
        <translation>Haut, Gesicht und Haar jeder Figur sind irgendwelche der Vorlage</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Each wears some of the template&apos;s parts, as hats and bags</source>
        <translation>Jeder trägt einige Teile der Vorlage, wie Hüte und Taschen</translation>
    </message>
    <message>
        <source>Clips (none: what suits)</source>
        <translation>Clips (keiner: was passt)</translation>
    </message>
    <message>
        <source>Of them</source>
        <translation>Davon</translation>
    </message>
    <message>
        <source>Characters under the brush hear the event while it plays. Rules say what they do then; the number can be a walking speed.</source>
        <translation>Figuren unter dem Pinsel hören das Ereignis, während abgespielt wird. Regeln sagen, was sie dann tun; die Zahl kann ein Gehtempo sein.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>On to the first place</source>
        <translation>Weiter zum ersten Ort</translation>
    </message>
    <message>
        <source>Jump to the first place</source>
        <translation>Zum ersten Ort springen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Somewhere to go to; does nothing by itself</source>
        <translation>Ein Ziel; tut von sich aus nichts</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>Nobody walks into it</source>
        <translation>Niemand geht hinein</translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation>Anziehendes</translation>
    </message>
    <message>
        <source>Draws those who walk near it</source>
        <translation>Zieht an, wer in der Nähe geht</translation>
    </message>
    <message>
        <source>Repeller</source>
        <translation>Abstoßendes</translation>
    </message>
    <message>
        <source>Those who walk near it keep away</source>
        <translation>Wer in der Nähe geht, hält Abstand</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Who reaches it leaves the scene</source>
        <translation>Wer ihn erreicht, verlässt die Szene</translation>
    </message>
    <message>
        <source>Slow ground</source>
        <translation>Langsamer Boden</translation>
    </message>
    <message>
        <source>Characters walk slower there</source>
        <translation>Figuren gehen dort langsamer</translation>
    </message>
    <message>
        <source>Forbidden ground</source>
        <translation>Verbotener Boden</translation>
    </message>
    <message>
        <source>Nobody walks there; ways lead around it</source>
        <translation>Niemand geht dort; Wege führen darum herum</translation>
    </message>
    <message>
        <source>Liked ground</source>
        <translation>Beliebter Boden</translation>
    </message>
    <message>
        <source>Ways lead over it where that is not much longer</source>
        <translation>Wege führen darüber, wo es kaum länger ist</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Change the height</source>
        <translation>Höhe ändern</translation>
    </message>
    <message>
        <source>Change the girth</source>
        <translation>Umfang ändern</translation>
    </message>
    <message>
        <source>Change how they walk</source>
        <translation>Gangart ändern</translation>
    </message>
    <message>
        <source>With which clip characters walk. None: what fits the speed. A clip that stays in place is left out.</source>
        <translation>Mit welchem Clip Figuren gehen. Keiner: was zum Tempo passt. Clips auf der Stelle fehlen hier.</translation>
    </message>
    <message>
        <source>Walk with</source>
        <translation>Gehen mit</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Change the path</source>
        <translation>Weg ändern</translation>
    </message>
    <message>
        <source>Characters walk along it when it plays</source>
        <translation>Figuren gehen ihn entlang, wenn abgespielt wird</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>A direction</source>
        <translation>Eine Richtung</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufall</translation>
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
        <source>Towards</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>The point to face</source>
        <translation>Punkt, zu dem sie schauen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Another material for each slot of a character</source>
        <translation>Ein anderes Material für jeden Slot einer Figur</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Gruppe ändern</translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation>Gehtempo</translation>
    </message>
    <message>
        <source>Metres per second; 0: the usual speed</source>
        <translation>Meter je Sekunde; 0: das übliche Tempo</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>Change character</source>
        <translation>Figur ändern</translation>
    </message>
    <message>
        <source>The group that new characters come into</source>
        <translation>Die Gruppe, in die neue Figuren kommen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>Only the selected</source>
        <translation>Nur die ausgewählten</translation>
    </message>
    <message>
        <source>Paint on the selected characters alone</source>
        <translation>Nur auf den ausgewählten Figuren malen</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>All but these</source>
        <translation>Alle außer diesen</translation>
    </message>
    <message>
        <source>Paint on those whom the mask leaves out</source>
        <translation>Auf denen malen, die die Maske auslässt</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Walk as one party</source>
        <translation>Gehen als eine Gesellschaft</translation>
    </message>
    <message>
        <source>All of them take the same branch of a path</source>
        <translation>Alle nehmen dieselbe Abzweigung eines Weges</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Colours and materials</source>
        <translation>Farben und Materialien</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Phase and speed of their clips</source>
        <translation>Phase und Tempo ihrer Clips</translation>
    </message>
    <message>
        <source>Clips, colours, materials and parts of the same names stay.</source>
        <translation>Clips, Farben, Materialien und Teile mit denselben Namen bleiben.</translation>
    </message>
    <message>
        <source>Who they become, by the operator</source>
        <translation>Wer sie werden, nach dem Operator</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>keine gewählt</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Figur</translation>
    </message>
    <message>
        <source>Ctrl+click somebody to choose</source>
        <translation>Mit Strg+Klick jemanden wählen</translation>
    </message>
    <message>
        <source>Clone</source>
        <translation>Klonen</translation>
    </message>
    <message>
        <source>Parts too</source>
        <translation>Auch Teile</translation>
    </message>
    <message>
        <source>Path, speed and way of walking</source>
        <translation>Weg, Tempo und Gangart</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Else it is hidden</source>
        <translation>Sonst wird es verborgen</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
    <message>
        <source>Push along</source>
        <translation>Entlangschieben</translation>
    </message>
    <message>
        <source>Gather</source>
        <translation>Sammeln</translation>
    </message>
    <message>
        <source>Spread apart</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Kämmen</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Neighbours within</source>
        <translation>Nachbarn im Umkreis von</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Of those of the same template</source>
        <translation>Von denen derselben Vorlage</translation>
    </message>
    <message>
        <source>Within a range</source>
        <translation>In einem Bereich</translation>
    </message>
    <message>
        <source>Wave along the stroke</source>
        <translation>Welle entlang des Strichs</translation>
    </message>
    <message>
        <source>Ripple from the press</source>
        <translation>Ringe vom Ansatz aus</translation>
    </message>
    <message>
        <source>All in step</source>
        <translation>Alle im Takt</translation>
    </message>
    <message>
        <source>From the shortest to the longest delay along the line that is drawn.</source>
        <translation>Von der kürzesten zur längsten Verzögerung entlang der gezogenen Linie.</translation>
    </message>
    <message>
        <source>They begin</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Speed of the wave</source>
        <translation>Tempo der Welle</translation>
    </message>
    <message>
        <source>What their template has</source>
        <translation>Was ihre Vorlage hat</translation>
    </message>
    <message>
        <source>As they were created</source>
        <translation>Wie sie erstellt wurden</translation>
    </message>
    <message>
        <source>As last saved</source>
        <translation>Wie zuletzt gespeichert</translation>
    </message>
    <message>
        <source>As before the last brush</source>
        <translation>Wie vor dem letzten Pinsel</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>As they were created: those of a file as they were when it was opened. As before the last brush: before the brush was taken up that was used before this one.</source>
        <translation>Wie sie erstellt wurden: die aus einer Datei so, wie sie beim Öffnen waren. Wie vor dem letzten Pinsel: bevor der Pinsel zur Hand genommen wurde, mit dem vor diesem gemalt wurde.</translation>
    </message>
    <message>
        <source>From the template: what suits standing or sitting, at the usual speed</source>
        <translation>Aus der Vorlage: was zum Stehen oder Sitzen passt, im üblichen Tempo</translation>
    </message>
    <message>
        <source>Materials and parts</source>
        <translation>Materialien und Teile</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Place and heading</source>
        <translation>Ort und Richtung</translation>
    </message>
    <message>
        <source>The last begins after</source>
        <translation>Letzte nach</translation>
    </message>
    <message>
        <source>0: all begin at the same moment</source>
        <translation>0: alle beginnen im selben Augenblick</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>from a point</source>
        <translation>von einem Punkt aus</translation>
    </message>
    <message>
        <source>Like a ring that grows on the ground</source>
        <translation>Wie ein Ring, der am Boden wächst</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>in Blickrichtung</translation>
    </message>
    <message>
        <source>Who is near in the picture begins</source>
        <translation>Wer im Bild nah ist, beginnt</translation>
    </message>
    <message>
        <source>row by row</source>
        <translation>Reihe für Reihe</translation>
    </message>
    <message>
        <source>From the front seats to the last row</source>
        <translation>Von den vorderen Sitzen bis zur letzten Reihe</translation>
    </message>
    <message>
        <source>block by block</source>
        <translation>Block für Block</translation>
    </message>
    <message>
        <source>From one wedge of seats to the next</source>
        <translation>Von einem Sitzblock zum nächsten</translation>
    </message>
    <message>
        <source>at random</source>
        <translation>zufällig</translation>
    </message>
    <message>
        <source>Each takes</source>
        <translation>Jeder braucht</translation>
    </message>
    <message>
        <source>Clips fade into each other, colours and sizes run, while it plays</source>
        <translation>Beim Abspielen gehen Clips ineinander über, Farben und Größen laufen</translation>
    </message>
    <message>
        <source>What a state has of them</source>
        <translation>Was ein Zustand von ihnen hat</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>All that it holds</source>
        <translation>Alles, was er enthält</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>Take it off</source>
        <translation>Abnehmen</translation>
    </message>
    <message>
        <source>Values (none: all of them)</source>
        <translation>Werte (keiner: alle)</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Merkmale</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>How often, against the others</source>
        <translation>Wie oft, gegen die anderen</translation>
    </message>
    <message>
        <source>any clip</source>
        <translation>jeder Clip</translation>
    </message>
    <message>
        <source>Whatever it is for; who sits plays those to sit with, gaits are walked with</source>
        <translation>Wofür er auch ist; wer sitzt, spielt die zum Sitzen, mit Gangarten wird gegangen</translation>
    </message>
    <message>
        <source>at rest, standing</source>
        <translation>ruhig stehend</translation>
    </message>
    <message>
        <source>walking</source>
        <translation>gehend</translation>
    </message>
    <message>
        <source>running</source>
        <translation>laufend</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>fliegend</translation>
    </message>
    <message>
        <source>at rest, sitting</source>
        <translation>ruhig sitzend</translation>
    </message>
    <message>
        <source>Words of the clip&apos;s name: “cheer” is also “sit_cheer”</source>
        <translation>Wörter aus dem Namen des Clips: „cheer“ ist auch „sit_cheer“</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Für</translation>
    </message>
    <message>
        <source>Words of the slot&apos;s name; empty: all that is worn and not named beside</source>
        <translation>Wörter aus dem Namen des Slots; leer: was getragen wird und sonst nicht genannt ist</translation>
    </message>
    <message>
        <source>The colour itself</source>
        <translation>Die Farbe selbst</translation>
    </message>
    <message>
        <source>Else it multiplies the material&apos;s</source>
        <translation>Sonst vervielfacht sie die des Materials</translation>
    </message>
    <message>
        <source>Add Material</source>
        <translation>Material hinzufügen</translation>
    </message>
    <message>
        <source>Words of the part&apos;s name; empty: all</source>
        <translation>Wörter aus dem Namen des Teils; leer: alle</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Shown in</source>
        <translation>Gezeigt in</translation>
    </message>
    <message>
        <source>Add Clip</source>
        <translation>Clip hinzufügen</translation>
    </message>
    <message>
        <source>A start of one&apos;s own</source>
        <translation>Eigener Anfang</translation>
    </message>
    <message>
        <source>How fast clips play</source>
        <translation>Tempo der Clips</translation>
    </message>
    <message>
        <source>How fast they walk</source>
        <translation>Tempo beim Gehen</translation>
    </message>
    <message>
        <source>How tall they are</source>
        <translation>Wie groß sie sind</translation>
    </message>
    <message>
        <source>How stout they are</source>
        <translation>Wie breit sie sind</translation>
    </message>
    <message>
        <source>Add Slot</source>
        <translation>Slot hinzufügen</translation>
    </message>
    <message>
        <source>Add Part</source>
        <translation>Teil hinzufügen</translation>
    </message>
    <message>
        <source>From A to B</source>
        <translation>Von A nach B</translation>
    </message>
    <message>
        <source>Those where the stroke begins to those where it ends; with a rectangle or lasso those of the first one to those of the second</source>
        <translation>Die am Anfang des Strichs mit denen an seinem Ende; mit Rechteck oder Lasso die des ersten mit denen des zweiten</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Each to the one before on the way of the brush</source>
        <translation>Jeder mit dem vorigen auf dem Weg des Pinsels</translation>
    </message>
    <message>
        <source>Some around</source>
        <translation>Einige ringsum</translation>
    </message>
    <message>
        <source>Each to a few of those around, drawn at random</source>
        <translation>Jeder mit einigen ringsum, zufällig gezogen</translation>
    </message>
    <message>
        <source>Each to each</source>
        <translation>Jeder mit jedem</translation>
    </message>
    <message>
        <source>All whom the stroke touches, with one another</source>
        <translation>Alle, die der Strich berührt, untereinander</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>Beziehung</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>How much they mean to each other; drawn for each relation</source>
        <translation>Wie viel sie einander bedeuten; für jede Beziehung gezogen</translation>
    </message>
    <message>
        <source>Take it away</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Relations of this kind go that those under the brush have; Ctrl while painting does the same</source>
        <translation>Beziehungen dieser Art, die die Figuren unter dem Pinsel haben, gehen weg; Strg beim Malen tut dasselbe</translation>
    </message>
    <message>
        <source>Mutual</source>
        <translation>Gegenseitig</translation>
    </message>
    <message>
        <source>Else it goes from one to the other alone, as from a leader to a follower</source>
        <translation>Sonst geht sie nur vom einen zum anderen, wie vom Anführer zum Gefolge</translation>
    </message>
    <message>
        <source>Share features</source>
        <translation>Merkmale teilen</translation>
    </message>
    <message>
        <source>Whoever is related to somebody on whom an emotion or an outfit is painted gets the same</source>
        <translation>Wer mit jemandem verbunden ist, auf den eine Stimmung oder Kleidung gemalt wird, bekommt dieselbe</translation>
    </message>
    <message>
        <source>When painted</source>
        <translation>Beim Bemalen</translation>
    </message>
    <message>
        <source>Share colours</source>
        <translation>Farben teilen</translation>
    </message>
    <message>
        <source>Whoever is related to somebody who is coloured gets the same colour</source>
        <translation>Wer mit jemandem verbunden ist, der gefärbt wird, bekommt dieselbe Farbe</translation>
    </message>
    <message>
        <source>As each likes</source>
        <translation>Wie jeder mag</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>Who walk the same path keep beside each other where there is room, and wait for each other</source>
        <translation>Wer denselben Weg geht, bleibt nebeneinander, wo Platz ist, und wartet aufeinander</translation>
    </message>
    <message>
        <source>Behind</source>
        <translation>Hinterher</translation>
    </message>
    <message>
        <source>Who has no path of his own follows the one from whom the relation goes</source>
        <translation>Wer keinen eigenen Weg hat, folgt dem, von dem die Beziehung ausgeht</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Auf Abstand</translation>
    </message>
    <message>
        <source>Who walk give each other a wide berth</source>
        <translation>Wer geht, macht einen weiten Bogen um den anderen</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>While it plays</source>
        <translation>Beim Abspielen</translation>
    </message>
    <message>
        <source>Face each other</source>
        <translation>Einander zuwenden</translation>
    </message>
    <message>
        <source>Who stand near each other turn to each other</source>
        <translation>Wer nahe beieinander steht, wendet sich einander zu</translation>
    </message>
    <message>
        <source>Pass events on</source>
        <translation>Ereignisse weitergeben</translation>
    </message>
    <message>
        <source>An event that one hears the others hear a little later, and so on from one to the next</source>
        <translation>Ein Ereignis, das einer hört, hören die anderen etwas später, und so weiter von einem zum nächsten</translation>
    </message>
    <message>
        <source>Where the sun stands</source>
        <translation>Wo die Sonne steht</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>How high the sun stands over the horizon</source>
        <translation>Wie hoch die Sonne über dem Horizont steht</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>How dark the shadows are that people and stages cast; 0: none</source>
        <translation>Wie dunkel die Schatten sind, die Figuren und Bühnen werfen; 0: keine</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>How large the sun is in the sky: the larger, the softer the edges of shadows</source>
        <translation>Wie groß die Sonne am Himmel ist: je größer, desto weicher die Ränder der Schatten</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>The colour of the light that comes from all of the sky</source>
        <translation>Die Farbe des Lichts, das vom ganzen Himmel kommt</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>The sky overhead</source>
        <translation>Der Himmel über den Köpfen</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizont</translation>
    </message>
    <message>
        <source>The sky at the horizon, and the ground far away</source>
        <translation>Der Himmel am Horizont und der Boden in der Ferne</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Lines a metre apart</source>
        <translation>Linien im Abstand von einem Meter</translation>
    </message>
    <message>
        <source>Noon</source>
        <translation>Mittag</translation>
    </message>
    <message>
        <source>Afternoon</source>
        <translation>Nachmittag</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Abenddämmerung</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Nacht</translation>
    </message>
    <message>
        <source>Spotlight</source>
        <translation>Scheinwerfer</translation>
    </message>
    <message>
        <source>Point light</source>
        <translation>Punktlicht</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>einen Ort</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>jemanden</translation>
    </message>
    <message>
        <source>It goes with him while it plays. Select somebody and press the button.</source>
        <translation>Er folgt ihm, während es läuft. Jemanden auswählen und die Schaltfläche drücken.</translation>
    </message>
    <message>
        <source>a group</source>
        <translation>eine Gruppe</translation>
    </message>
    <message>
        <source>It goes with the middle of those in it.</source>
        <translation>Er folgt der Mitte derer, die darin sind.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>At 100 % it is as bright as the sun ten metres away; nearer it is brighter</source>
        <translation>Bei 100 % ist es in zehn Metern Entfernung so hell wie die Sonne, näher heller</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>How wide it opens</source>
        <translation>Wie weit er sich öffnet</translation>
    </message>
    <message>
        <source>Soft Edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>How much of it is seen in the air, as in smoke</source>
        <translation>Wie viel davon in der Luft zu sehen ist, wie in Rauch</translation>
    </message>
    <message>
        <source>Aims at</source>
        <translation>Gerichtet auf</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Where it hangs or stands</source>
        <translation>Wo sie hängt oder steht</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie es ist</translation>
    </message>
    <message>
        <source>Filmic</source>
        <translation>Wie auf Film</translation>
    </message>
    <message>
        <source>Haze</source>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>How much of what is a hundred metres away the air hides</source>
        <translation>Wie viel von dem, was hundert Meter entfernt ist, die Luft verdeckt</translation>
    </message>
    <message>
        <source>Air and Exposure</source>
        <translation>Luft und Belichtung</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Each stop doubles the brightness</source>
        <translation>Jede Blende verdoppelt die Helligkeit</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>The colour of light that looks white: lower makes the picture bluer, higher warmer</source>
        <translation>Die Farbe des Lichts, das weiß aussieht: niedriger macht das Bild blauer, höher wärmer</translation>
    </message>
    <message>
        <source> K</source>
        <translation> K</translation>
    </message>
    <message>
        <source>Tone</source>
        <translation>Tonwerte</translation>
    </message>
    <message>
        <source>What is brighter than white</source>
        <translation>Was heller als Weiß ist</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>How dark it is in corners, under people and where they sit: less of the sky is seen from there</source>
        <translation>Wie dunkel es in Ecken ist, unter Menschen und wo sie sitzen: von dort ist weniger vom Himmel zu sehen</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>wählen …</translation>
    </message>
    <message>
        <source>Drag a line: from the lower to the higher values along it.</source>
        <translation>Eine Linie ziehen: entlang ihr von den niedrigeren zu den höheren Werten.</translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last colour along it.</source>
        <translation>Eine Linie ziehen: entlang ihr von der ersten zur letzten Farbe.</translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last value along it.</source>
        <translation>Eine Linie ziehen: entlang ihr vom ersten zum letzten Wert.</translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last material along it.</source>
        <translation>Eine Linie ziehen: entlang ihr vom ersten zum letzten Material.</translation>
    </message>
    <message>
        <source>Drag a line: they face along it.</source>
        <translation>Eine Linie ziehen: Sie blicken in ihre Richtung.</translation>
    </message>
    <message>
        <source>Small groups</source>
        <translation>Kleine Gruppen</translation>
    </message>
    <message>
        <source>A few of the nearest are related with one another, as families are: two of another look, and smaller ones with them</source>
        <translation>Einige der Nächsten stehen miteinander in Beziehung, so wie Familien: zwei, die verschieden aussehen, und Kleinere bei ihnen</translation>
    </message>
    <message>
        <source>Drag a line: from the slower to the faster along it.</source>
        <translation>Eine Linie ziehen: entlang ihr von den langsameren zu den schnelleren.</translation>
    </message>
    <message>
        <source>Drag a line: from the first to the last template along it.</source>
        <translation>Eine Linie ziehen: entlang ihr von der ersten zur letzten Vorlage.</translation>
    </message>
    <message>
        <source>People and stages stand in its light. The four strongest lights that are to cast shadows do.</source>
        <translation>Figuren und Bühnen stehen in seinem Licht. Von den Lichtern, die Schatten werfen sollen, tun es die vier stärksten.</translation>
    </message>
    <message>
        <source>They bear none of it any more: what it did to them is as their template has it</source>
        <translation>Sie tragen nichts davon mehr: Was es an ihnen bewirkt hat, ist wieder wie in ihrer Vorlage</translation>
    </message>
    <message>
        <source>Lies low, up to</source>
        <translation>Liegt tief, bis</translation>
    </message>
    <message>
        <source>The height above the ground at which a third of it is left, as of mist over a square; 0: it is everywhere alike</source>
        <translation>Die Höhe über dem Boden, in der noch ein Drittel davon übrig ist, wie bei Nebel über einem Platz; 0: überall gleich</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>How strongly what is smooth, as water, glass, metal and skin, mirrors the sun, the lamps and the sky; 0: not</source>
        <translation>Wie stark Glattes wie Wasser, Glas, Metall und Haut Sonne, Lampen und Himmel spiegelt; 0: gar nicht</translation>
    </message>
    <message>
        <source>Plain colours</source>
        <translation>Einfache Farben</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Beleuchtet</translation>
    </message>
    <message>
        <source>Cartoon</source>
        <translation>Comic</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Gips</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Blaupause</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>By property</source>
        <translation>Nach Eigenschaft</translation>
    </message>
    <message>
        <source>The scene&apos;s</source>
        <translation>Das der Szene</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>How surfaces are drawn</source>
        <translation>Wie Flächen gezeichnet werden</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Spotlights</source>
        <translation>Scheinwerfer</translation>
    </message>
    <message>
        <source>The lights that stand in the scene shine</source>
        <translation>Die Lichter, die in der Szene stehen, leuchten</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>One colour instead of the sky</source>
        <translation>Eine Farbe statt des Himmels</translation>
    </message>
    <message>
        <source>The ground around stages is drawn</source>
        <translation>Der Boden um die Bühnen wird gezeichnet</translation>
    </message>
    <message>
        <source>Own Outlines</source>
        <translation>Eigene Umrisse</translation>
    </message>
    <message>
        <source>Lines around things, instead of those that the style has</source>
        <translation>Linien um alles, statt derer, die der Stil hat</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>nothing: a marker</source>
        <translation>nichts: ein Merkpunkt</translation>
    </message>
    <message>
        <source>A name for a moment</source>
        <translation>Ein Name für einen Augenblick</translation>
    </message>
    <message>
        <source>call a cue</source>
        <translation>Stichwort geben</translation>
    </message>
    <message>
        <source>What the cue sends, and the state it recalls</source>
        <translation>Was das Stichwort sendet, und der Zustand, den es abruft</translation>
    </message>
    <message>
        <source>recall a state</source>
        <translation>Zustand abrufen</translation>
    </message>
    <message>
        <source>In the run alone: the scene stays as it is</source>
        <translation>Nur in diesem Lauf: die Szene bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>send an event</source>
        <translation>Ereignis senden</translation>
    </message>
    <message>
        <source>Rules answer it</source>
        <translation>Regeln antworten darauf</translation>
    </message>
    <message>
        <source>Without one it is called after what happens</source>
        <translation>Ohne Namen heißt sie nach dem, was geschieht</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>When it happens, by the clock</source>
        <translation>Wann es geschieht, nach der Uhr</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>Cue</source>
        <translation>Stichwort</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>That comes along: rules ask for it</source>
        <translation>Die mitkommt: Regeln fragen danach</translation>
    </message>
    <message>
        <source>move the camera</source>
        <translation>die Kamera bewegen</translation>
    </message>
    <message>
        <source>A cut, or a move that takes its time</source>
        <translation>Ein Schnitt, oder eine Fahrt, die ihre Zeit braucht</translation>
    </message>
    <message>
        <source>At once, or as a flight</source>
        <translation>Sofort, oder im Flug</translation>
    </message>
    <message>
        <source>Around what it looks at</source>
        <translation>Um das, was sie anblickt</translation>
    </message>
    <message>
        <source>From its first place to its last</source>
        <translation>Von seinem ersten Ort zum letzten</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Where it goes to, or begins with</source>
        <translation>Wohin sie fährt, oder womit sie beginnt</translation>
    </message>
    <message>
        <source>From where it is</source>
        <translation>Von da, wo sie ist</translation>
    </message>
    <message>
        <source>360°: once around; less than nothing: the other way</source>
        <translation>360°: einmal herum; unter null: andersherum</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Dauert</translation>
    </message>
    <message>
        <source>0: at once, a cut</source>
        <translation>0: sofort, ein Schnitt</translation>
    </message>
    <message>
        <source>Above it</source>
        <translation>Darüber</translation>
    </message>
    <message>
        <source>Looks ahead</source>
        <translation>Blickt voraus</translation>
    </message>
    <message>
        <source>Else at what it looked at before</source>
        <translation>Sonst auf das, was sie vorher anblickte</translation>
    </message>
    <message>
        <source>Gently</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>It begins and ends slowly</source>
        <translation>Sie beginnt und endet langsam</translation>
    </message>
    <message>
        <source>to a camera</source>
        <translation>zu einer Kamera</translation>
    </message>
    <message>
        <source>around</source>
        <translation>im Kreis</translation>
    </message>
    <message>
        <source>along a path</source>
        <translation>einen Weg entlang</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>Turns by</source>
        <translation>Dreht um</translation>
    </message>
    <message>
        <source>later or earlier</source>
        <translation>später oder früher</translation>
    </message>
    <message>
        <source>Everything that they do, by some seconds</source>
        <translation>Alles, was sie tun, um einige Sekunden</translation>
    </message>
    <message>
        <source>slower or faster</source>
        <translation>langsamer oder schneller</translation>
    </message>
    <message>
        <source>For a while; they are late, or early, from then on</source>
        <translation>Eine Weile lang; von da an sind sie später dran, oder früher</translation>
    </message>
    <message>
        <source>beside their way</source>
        <translation>neben ihrem Weg</translation>
    </message>
    <message>
        <source>To the right or to the left</source>
        <translation>Nach rechts oder links</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>Nobody sees them for a while</source>
        <translation>Eine Weile lang sieht sie niemand</translation>
    </message>
    <message>
        <source>They are</source>
        <translation>Sie sind</translation>
    </message>
    <message>
        <source>Later by</source>
        <translation>Später um</translation>
    </message>
    <message>
        <source>Less than nothing: earlier</source>
        <translation>Weniger als nichts: früher</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>100 %: as it was; 0 %: they stand still</source>
        <translation>100 %: wie es war; 0 %: sie stehen still</translation>
    </message>
    <message>
        <source>To the right by</source>
        <translation>Nach rechts um</translation>
    </message>
    <message>
        <source>Less than nothing: to the left</source>
        <translation>Weniger als nichts: nach links</translation>
    </message>
    <message>
        <source>By the clock</source>
        <translation>Nach der Uhr</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Not after the beginning: to the end of the take</source>
        <translation>Nicht nach dem Anfang: bis zum Ende des Takes</translation>
    </message>
    <message>
        <source>The play range</source>
        <translation>Der Abspielbereich</translation>
    </message>
    <message>
        <source>From now to the end</source>
        <translation>Von jetzt bis zum Ende</translation>
    </message>
    <message>
        <source>From now for a while</source>
        <translation>Von jetzt an eine Weile</translation>
    </message>
    <message>
        <source>While a take is shown: those under the brush do this part of it again, by the rules and properties that they have now. Everybody else does what he did, and is avoided. The result is another take.</source>
        <translation>Während ein Take gezeigt wird: Wer unter dem Pinsel ist, spielt diesen Teil neu, nach den Regeln und Eigenschaften, die er jetzt hat. Alle anderen tun, was sie taten, und man weicht ihnen aus. Das Ergebnis ist ein weiterer Take.</translation>
    </message>
    <message>
        <source>The play range is set in the timeline; without one it is from now to the end</source>
        <translation>Der Abspielbereich wird in der Zeitleiste gesetzt; ohne ihn ist es von jetzt bis zum Ende</translation>
    </message>
    <message>
        <source>Retake</source>
        <translation>Neu spielen</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Which part</source>
        <translation>Welcher Teil</translation>
    </message>
    <message>
        <source>Different each time</source>
        <translation>Jedes Mal anders</translation>
    </message>
    <message>
        <source>Chance falls otherwise each time. Off: only what has been changed since makes a difference.</source>
        <translation>Der Zufall fällt jedes Mal anders. Aus: Nur was seither geändert wurde, macht einen Unterschied.</translation>
    </message>
    <message>
        <source>somebody else</source>
        <translation>jemand anderes</translation>
    </message>
    <message>
        <source>Of another template, doing what they do</source>
        <translation>Von einer anderen Vorlage; sie tun, was sie tun</translation>
    </message>
    <message>
        <source>Of template</source>
        <translation>Von Vorlage</translation>
    </message>
    <message>
        <source>Of several, each is of one</source>
        <translation>Von mehreren hat jede Figur eine</translation>
    </message>
    <message>
        <source>Time of Day</source>
        <translation>Tageszeit</translation>
    </message>
    <message>
        <source>Puts sun or moon, sky and their colours as they are at that hour, paler and softer where there is haze; everything can be changed afterwards</source>
        <translation>Setzt Sonne oder Mond, Himmel und ihre Farben, wie sie zu dieser Stunde sind, blasser und weicher bei Dunst; alles lässt sich danach ändern</translation>
    </message>
    <message>
        <source> h</source>
        <translation> Uhr</translation>
    </message>
    <message>
        <source>Around its upright axis</source>
        <translation>Um ihre senkrechte Achse</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Without perspective, as in a plan</source>
        <translation>Ohne Perspektive, wie in einem Plan</translation>
    </message>
    <message>
        <source>Angle of View</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>From the picture&apos;s lower edge to its upper one. Small: as through a long lens; large: a wide one</source>
        <translation>Vom unteren Bildrand zum oberen. Klein: wie durch ein Teleobjektiv; groß: wie durch ein Weitwinkel</translation>
    </message>
    <message>
        <source>What the picture shows from its lower edge to its upper one</source>
        <translation>Was das Bild vom unteren Rand zum oberen zeigt</translation>
    </message>
    <message>
        <source>Of the lamp: what is nearer to it than that gets no brighter</source>
        <translation>Der Lampe: was ihr näher ist als das, wird nicht heller</translation>
    </message>
    <message>
        <source>Only After Dark</source>
        <translation>Nur bei Dunkelheit</translation>
    </message>
    <message>
        <source>Its own</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Begins as what is seen, and can be set below</source>
        <translation>Beginnt mit dem, was man sieht, und lässt sich unten einstellen</translation>
    </message>
    <message>
        <source>Sun and sky: those of the scene, ready-made ones, or its own</source>
        <translation>Sonne und Himmel: die der Szene, fertige oder eigene</translation>
    </message>
    <message>
        <source>As street lamps: it shines while sun and sky are dark</source>
        <translation>Wie Straßenlaternen: es leuchtet, solange Sonne und Himmel dunkel sind</translation>
    </message>
    <message>
        <source>Two Tones</source>
        <translation>Zwei Töne</translation>
    </message>
    <message>
        <source>Light and shade alone, without a step between</source>
        <translation>Nur Licht und Schatten, ohne Stufe dazwischen</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>A disc</source>
        <translation>Eine Scheibe</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>A wall, a fence, a kerb: from corner to corner</source>
        <translation>Eine Mauer, ein Zaun, ein Bordstein: von Ecke zu Ecke</translation>
    </message>
    <message>
        <source>All that its corners enclose</source>
        <translation>Alles, was ihre Ecken umschließen</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Also hidden</source>
        <translation>Auch Verdeckte</translation>
    </message>
    <message>
        <source>Each click puts one there.</source>
        <translation>Jeder Klick setzt einen Ort.</translation>
    </message>
    <message>
        <source>Each click adds a corner, a drag draws freely; Enter or a double click ends it, a click on the first corner closes it.</source>
        <translation>Jeder Klick setzt eine Ecke, Ziehen zeichnet frei; Eingabe oder ein Doppelklick beendet sie, ein Klick auf die erste Ecke schließt sie.</translation>
    </message>
    <message>
        <source>Each click adds a place; Enter, Escape or a double click ends the path, a click on its first place closes it. The next click begins another one.</source>
        <translation>Jeder Klick fügt einen Ort hinzu; Eingabe, Escape oder ein Doppelklick beendet den Weg, ein Klick auf seinen ersten Ort schließt ihn. Der nächste Klick beginnt einen neuen.</translation>
    </message>
</context>
<context>
    <name>FindWords</name>
    <message>
        <source>people spray add place populate audience</source>
        <translation>Leute Menschen sprühen hinzufügen setzen bevölkern Publikum Zuschauer</translation>
    </message>
    <message>
        <source>erase eraser rubber remove people</source>
        <translation>radieren Radiergummi entfernen weg Leute</translation>
    </message>
    <message>
        <source>color dye clothes tint paint</source>
        <translation>färben Kleider einfärben Ton anmalen</translation>
    </message>
    <message>
        <source>clothes dress costume uniform fans team</source>
        <translation>Kleider anziehen Kostüm Uniform Fans Mannschaft Trikot</translation>
    </message>
    <message>
        <source>skin hair cloth texture variant</source>
        <translation>Haut Haare Stoff Textur Variante</translation>
    </message>
    <message>
        <source>hat bag props accessories</source>
        <translation>Hut Tasche Requisiten Zubehör</translation>
    </message>
    <message>
        <source>dance clap wave cheer motion pose move</source>
        <translation>tanzen klatschen winken jubeln Bewegung Pose bewegen</translation>
    </message>
    <message>
        <source>gait speed run stroll</source>
        <translation>Gangart Tempo rennen schlendern</translation>
    </message>
    <message>
        <source>offset phase synchronous delay wave</source>
        <translation>Versatz Phase gleichzeitig Verzögerung Welle La-Ola</translation>
    </message>
    <message>
        <source>turn rotate look face direction</source>
        <translation>drehen rotieren schauen blicken Richtung</translation>
    </message>
    <message>
        <source>size tall small fat thin</source>
        <translation>Größe groß klein dick dünn</translation>
    </message>
    <message>
        <source>mood emotion happy sad attribute</source>
        <translation>Stimmung Gefühl fröhlich traurig Eigenschaft</translation>
    </message>
    <message>
        <source>trigger message signal</source>
        <translation>auslösen Nachricht Signal</translation>
    </message>
    <message>
        <source>go target destination send</source>
        <translation>hingehen Ziel losschicken</translation>
    </message>
    <message>
        <source>route way road line street parade queue</source>
        <translation>Route Weg Strecke Linie Straße Umzug Schlange</translation>
    </message>
    <message>
        <source>wall fence barrier obstacle exit entrance door area zone</source>
        <translation>Mauer Wand Zaun Absperrung Hindernis Ausgang Eingang Tür Fläche Zone</translation>
    </message>
    <message>
        <source>shove spread move comb</source>
        <translation>drücken verteilen verschieben kämmen</translation>
    </message>
    <message>
        <source>family friends couple pair link</source>
        <translation>Familie Freunde Paar Verbindung</translation>
    </message>
    <message>
        <source>family team layer flock</source>
        <translation>Familie Mannschaft Ebene Schwarm</translation>
    </message>
    <message>
        <source>undo original back reset former</source>
        <translation>rückgängig ursprünglich zurück zurücksetzen vorher</translation>
    </message>
    <message>
        <source>mix swap random</source>
        <translation>mischen tauschen zufällig</translation>
    </message>
    <message>
        <source>blur even average</source>
        <translation>weichzeichnen angleichen Mittelwert</translation>
    </message>
    <message>
        <source>copy stamp duplicate</source>
        <translation>kopieren Stempel duplizieren</translation>
    </message>
    <message>
        <source>replace character model exchange</source>
        <translation>ersetzen Charakter Modell austauschen</translation>
    </message>
    <message>
        <source>label mark keyword</source>
        <translation>Etikett markieren Schlagwort</translation>
    </message>
    <message>
        <source>arrow pointer choose pick move</source>
        <translation>Pfeil Zeiger wählen anklicken verschieben</translation>
    </message>
    <message>
        <source>characters people models stages assets</source>
        <translation>Figuren Leute Modelle Bühnen Assets</translation>
    </message>
    <message>
        <source>character model figure glTF GLB Mixamo Blender load</source>
        <translation>Charakter Modell Figur glTF GLB Mixamo Blender laden</translation>
    </message>
    <message>
        <source>set building scenery model glTF GLB background load</source>
        <translation>Kulisse Gebäude Szenerie Modell glTF GLB Hintergrund laden</translation>
    </message>
    <message>
        <source>render export screenshot image PNG EXR still</source>
        <translation>rendern exportieren Bildschirmfoto Bild PNG EXR Standbild</translation>
    </message>
    <message>
        <source>render export video film MP4 GIF animation</source>
        <translation>rendern exportieren Video Film MP4 GIF Animation</translation>
    </message>
    <message>
        <source>bookmark viewpoint shot</source>
        <translation>Lesezeichen Blickpunkt Einstellung</translation>
    </message>
    <message>
        <source>keyframe key flight move shot</source>
        <translation>Keyframe Schlüsselbild Flug Fahrt Einstellung</translation>
    </message>
    <message>
        <source>copy paste clone</source>
        <translation>kopieren einfügen klonen</translation>
    </message>
    <message>
        <source>back revert mistake</source>
        <translation>zurück rückgängig Fehler</translation>
    </message>
    <message>
        <source>settings options language memory tablet</source>
        <translation>Einstellungen Optionen Sprache Speicher Tablett</translation>
    </message>
    <message>
        <source>loop repeat cycle</source>
        <translation>Schleife wiederholen Loop</translation>
    </message>
    <message>
        <source>freeze bake position stop</source>
        <translation>einfrieren festhalten Position anhalten</translation>
    </message>
    <message>
        <source>drop floor snap height</source>
        <translation>fallen lassen Boden einrasten Höhe</translation>
    </message>
    <message>
        <source>navmesh navigation mesh floor</source>
        <translation>Navmesh Navigation Boden</translation>
    </message>
    <message>
        <source>canvas docks interface hide</source>
        <translation>Leinwand Docks Oberfläche ausblenden</translation>
    </message>
    <message>
        <source>lamp sun sky night day shadow fog spotlight</source>
        <translation>Lampe Sonne Himmel Nacht Tag Schatten Nebel Strahler</translation>
    </message>
    <message>
        <source>wall fence obstacle exit entrance door area zone places</source>
        <translation>Mauer Wand Zaun Hindernis Ausgang Eingang Tür Fläche Zone Orte</translation>
    </message>
    <message>
        <source>behaviour behavior trigger condition if cue</source>
        <translation>Verhalten Auslöser Bedingung wenn Stichwort</translation>
    </message>
    <message>
        <source>snapshot pose version mood</source>
        <translation>Schnappschuss Pose Fassung Stimmung</translation>
    </message>
    <message>
        <source>keyframe animation marker schedule</source>
        <translation>Keyframe Animation Markierung Ablauf</translation>
    </message>
    <message>
        <source>recording cache simulation bake</source>
        <translation>Aufnahme Cache Simulation</translation>
    </message>
    <message>
        <source>undo back steps</source>
        <translation>rückgängig zurück Schritte</translation>
    </message>
    <message>
        <source>layers edit later stack</source>
        <translation>Ebenen später bearbeiten Stapel</translation>
    </message>
    <message>
        <source>favourites favorites saved brushes</source>
        <translation>Favoriten gespeicherte Pinsel</translation>
    </message>
    <message>
        <source>selected person inspector properties</source>
        <translation>ausgewählte Person Inspektor Eigenschaften</translation>
    </message>
    <message>
        <source>outliner stages characters files missing</source>
        <translation>Outliner Bühnen Figuren Dateien fehlende</translation>
    </message>
    <message>
        <source>characters models mix weights people</source>
        <translation>Figuren Modelle Mischung Gewichte Leute</translation>
    </message>
    <message>
        <source>color palette swatches dropper wheel</source>
        <translation>Palette Farbfelder Pipette Farbkreis</translation>
    </message>
    <message>
        <source>mood emotion attributes</source>
        <translation>Stimmung Gefühl Eigenschaften</translation>
    </message>
    <message>
        <source>family friends links network</source>
        <translation>Familie Freunde Verbindungen Netz</translation>
    </message>
    <message>
        <source>layers families teams visibility hide lock</source>
        <translation>Ebenen Familien Mannschaften Sichtbarkeit ausblenden sperren</translation>
    </message>
    <message>
        <source>script code programming</source>
        <translation>Skript Code programmieren</translation>
    </message>
    <message>
        <source>style cartoon clay background tone comic</source>
        <translation>Stil Cartoon Ton Gips Hintergrund Comic Zeichentrick</translation>
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
    <name>GroupCommands</name>
    <message>
        <source>New group</source>
        <translation>Neue Gruppe</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Nobody is selected: there is nobody to take in.</source>
        <translation>Niemand ist ausgewählt: Es gibt niemanden zum Aufnehmen.</translation>
    </message>
    <message numerus="yes">
        <source>Take %n character(s) into a group</source>
        <translation>
            <numerusform>%n Figur in eine Gruppe nehmen</numerusform>
            <numerusform>%n Figuren in eine Gruppe nehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>The group is locked or hidden: its characters cannot be selected.</source>
        <translation>Die Gruppe ist gesperrt oder ausgeblendet: Ihre Figuren lassen sich nicht auswählen.</translation>
    </message>
    <message>
        <source>Delete a group</source>
        <translation>Gruppe löschen</translation>
    </message>
    <message>
        <source>Show a group alone</source>
        <translation>Eine Gruppe allein zeigen</translation>
    </message>
</context>
<context>
    <name>HandEdits</name>
    <message>
        <source>%1 s earlier</source>
        <translation>%1 s früher</translation>
    </message>
    <message>
        <source>%1 s later</source>
        <translation>%1 s später</translation>
    </message>
    <message>
        <source>still</source>
        <translation>steht still</translation>
    </message>
    <message>
        <source>at %1 % of the pace</source>
        <translation>mit %1 % des Tempos</translation>
    </message>
    <message>
        <source>%1 m to the left</source>
        <translation>%1 m nach links</translation>
    </message>
    <message>
        <source>%1 m to the right</source>
        <translation>%1 m nach rechts</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>%1, from %2 on</source>
        <translation>%1, ab %2</translation>
    </message>
    <message>
        <source>Keep what was played as a take and show it: then people of it can be edited by hand.</source>
        <translation>Behalten Sie, was gespielt wurde, als Take und zeigen Sie ihn: dann lassen sich seine Figuren von Hand ändern.</translation>
    </message>
    <message>
        <source>Select those who are to be edited.</source>
        <translation>Wählen Sie die Figuren, die geändert werden sollen.</translation>
    </message>
    <message>
        <source>There are as many edits as a take can have. Delete some.</source>
        <translation>Es gibt so viele Änderungen, wie ein Take haben kann. Löschen Sie einige.</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n character(s) of the take</source>
        <translation>
            <numerusform>%n Figur des Takes ändern</numerusform>
            <numerusform>%n Figuren des Takes ändern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n character(s): %1.</source>
        <translation>
            <numerusform>%n Figur: %1.</numerusform>
            <numerusform>%n Figuren: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Switch an edit on</source>
        <translation>Eine Änderung einschalten</translation>
    </message>
    <message>
        <source>Switch an edit off</source>
        <translation>Eine Änderung ausschalten</translation>
    </message>
    <message>
        <source>Switch the take&apos;s edits on</source>
        <translation>Änderungen des Takes einschalten</translation>
    </message>
    <message>
        <source>Switch the take&apos;s edits off</source>
        <translation>Änderungen des Takes ausschalten</translation>
    </message>
    <message>
        <source>Delete an edit</source>
        <translation>Eine Änderung löschen</translation>
    </message>
    <message>
        <source>%1, %2–%3</source>
        <translation>%1, %2–%3</translation>
    </message>
    <message>
        <source>somebody else: choose of which template</source>
        <translation>jemand anderes: Wählen Sie, von welcher Vorlage</translation>
    </message>
    <message>
        <source>somebody else: %1</source>
        <translation>jemand anderes: %1</translation>
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
    <name>IndividualWriter</name>
    <message>
        <source>Change template</source>
        <translation>Vorlage wechseln</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Change tags</source>
        <translation>Marken ändern</translation>
    </message>
    <message>
        <source>Change clip</source>
        <translation>Clip ändern</translation>
    </message>
    <message>
        <source>Sit down</source>
        <translation>Hinsetzen</translation>
    </message>
    <message>
        <source>There is no seat %1.</source>
        <translation>Es gibt keinen Sitz %1.</translation>
    </message>
    <message>
        <source>Somebody else sits on seat %1.</source>
        <translation>Auf Sitz %1 sitzt schon jemand.</translation>
    </message>
    <message>
        <source>Stand up</source>
        <translation>Aufstehen</translation>
    </message>
    <message>
        <source>Change tint</source>
        <translation>Tönung ändern</translation>
    </message>
    <message>
        <source>Change the mode of a tint</source>
        <translation>Modus einer Tönung ändern</translation>
    </message>
    <message>
        <source>Change outfit</source>
        <translation>Kleidung ändern</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Teil verbergen</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>As the System</source>
        <translation>Wie das System</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <extracomment>the name of this language in this language</extracomment>
        <translation>Deutsch</translation>
    </message>
</context>
<context>
    <name>LightCommands</name>
    <message>
        <source>A scene has at most %1 lights: remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Lichter: zuerst eines entfernen.</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>Remove a light</source>
        <translation>Licht entfernen</translation>
    </message>
</context>
<context>
    <name>LightHandles</name>
    <message>
        <source>Move a light</source>
        <translation>Licht bewegen</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>%1 m hoch</translation>
    </message>
    <message>
        <source>Change a cone</source>
        <translation>Lichtkegel ändern</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>LookCommands</name>
    <message>
        <source>A scene has at most %1 looks: remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Looks: Entfernen Sie zuerst einen.</translation>
    </message>
    <message>
        <source>Add a look</source>
        <translation>Look hinzufügen</translation>
    </message>
    <message>
        <source>Remove a look</source>
        <translation>Look entfernen</translation>
    </message>
    <message>
        <source>A look needs a name.</source>
        <translation>Ein Look braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a look “%1” already.</source>
        <translation>Es gibt schon einen Look „%1“.</translation>
    </message>
    <message>
        <source>Rename a look</source>
        <translation>Look umbenennen</translation>
    </message>
    <message>
        <source>Move a look</source>
        <translation>Look verschieben</translation>
    </message>
    <message>
        <source>Take looks</source>
        <translation>Looks übernehmen</translation>
    </message>
</context>
<context>
    <name>Looks</name>
    <message>
        <source>&amp;Plain Colours</source>
        <translation>&amp;Einfache Farben</translation>
    </message>
    <message>
        <source>Base colours without light</source>
        <translation>Grundfarben ohne Licht</translation>
    </message>
    <message>
        <source>&amp;Lit</source>
        <translation>&amp;Beleuchtet</translation>
    </message>
    <message>
        <source>Light of the sun and the sky</source>
        <translation>Licht von Sonne und Himmel</translation>
    </message>
    <message>
        <source>&amp;Cartoon</source>
        <translation>&amp;Comic</translation>
    </message>
    <message>
        <source>Ink lines, and light in three steps</source>
        <translation>Tuschelinien, und Licht in drei Stufen</translation>
    </message>
    <message>
        <source>Cl&amp;ay</source>
        <translation>&amp;Gips</translation>
    </message>
    <message>
        <source>Shapes and light alone: everything of one material</source>
        <translation>Nur Formen und Licht: alles aus einem Material</translation>
    </message>
    <message>
        <source>&amp;Silhouettes</source>
        <translation>&amp;Silhouetten</translation>
    </message>
    <message>
        <source>Dark people on a bright ground, as a crowd is read</source>
        <translation>Dunkle Figuren auf hellem Grund: So liest sich eine Menge</translation>
    </message>
    <message>
        <source>&amp;Blueprint</source>
        <translation>B&amp;laupause</translation>
    </message>
    <message>
        <source>Bright lines on blue, as a plan is drawn</source>
        <translation>Helle Linien auf Blau, wie auf einem Plan</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Edges of the triangles that are drawn</source>
        <translation>Kanten der Dreiecke, die gezeichnet werden</translation>
    </message>
    <message>
        <source>By P&amp;roperty</source>
        <translation>&amp;Nach Eigenschaft</translation>
    </message>
    <message>
        <source>A colour for each template, group, mood, density and more, with a legend</source>
        <translation>Je eine Farbe für Vorlagen, Gruppen, Stimmungen, Dichte und mehr, mit Legende</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Evening</source>
        <translation>Abend</translation>
    </message>
    <message>
        <source>Spotlights</source>
        <translation>Scheinwerfer</translation>
    </message>
    <message>
        <source>Comic</source>
        <translation>Comic</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
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
        <translation>Abspie&amp;len</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Script</source>
        <translation>&amp;Skript</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open &amp;Example</source>
        <translation>Be&amp;ispiel öffnen</translation>
    </message>
    <message>
        <source>Go to &amp;Camera</source>
        <translation>Zu &amp;Kamera</translation>
    </message>
    <message>
        <source>Keep View as Ca&amp;mera</source>
        <translation>Ansicht als Kamera &amp;merken</translation>
    </message>
    <message>
        <source>Len&amp;gth of a Step</source>
        <translation>Län&amp;ge eines Schritts</translation>
    </message>
    <message>
        <source>&amp;Make Path of Places</source>
        <translation>Aus Orten einen Weg &amp;machen</translation>
    </message>
    <message>
        <source>Dra&amp;wn As</source>
        <translation>Darstell&amp;ung</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache (Language)</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswahl</translation>
    </message>
    <message>
        <source>&amp;Crowd</source>
        <translation>&amp;Menge</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Bewegung</translation>
    </message>
    <message>
        <source>&amp;Ways and Places</source>
        <translation>&amp;Wege und Orte</translation>
    </message>
    <message>
        <source>&amp;Behaviour and Groups</source>
        <translation>&amp;Verhalten und Gruppen</translation>
    </message>
    <message>
        <source>&amp;Values and Scripts</source>
        <translation>Werte und &amp;Skripte</translation>
    </message>
    <message>
        <source>Recall &amp;State</source>
        <translation>&amp;Zustand abrufen</translation>
    </message>
    <message>
        <source>&amp;Keep State</source>
        <translation>Zustand &amp;merken</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>%1 must be a tag from 0 to 63</source>
        <translation>%1 muss eine Marke von 0 bis 63 sein</translation>
    </message>
    <message>
        <source>%1 must lie between %2 and %3</source>
        <translation>%1 muss zwischen %2 und %3 liegen</translation>
    </message>
    <message>
        <source>%1 must be one of: %2</source>
        <translation>%1 muss eines davon sein: %2</translation>
    </message>
    <message>
        <source>%1 must be a whole number that is not negative and not too large</source>
        <translation>%1 muss eine ganze Zahl sein, nicht negativ und nicht zu groß</translation>
    </message>
    <message>
        <source>%1 must be at most %2</source>
        <translation>%1 darf höchstens %2 sein</translation>
    </message>
    <message>
        <source>%1 must be at least %2</source>
        <translation>%1 muss mindestens %2 sein</translation>
    </message>
    <message>
        <source>%1 must be a finite number</source>
        <translation>%1 muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>%1 must be a colour and its strength, as &quot;#f0962cff&quot;</source>
        <translation>%1 muss eine Farbe mit ihrer Stärke sein, wie „#f0962cff“</translation>
    </message>
    <message>
        <source>%1 must be true, false or null</source>
        <translation>%1 muss true, false oder null sein</translation>
    </message>
    <message>
        <source>%1 must be a list of %2 numbers from %3 to %4</source>
        <translation>%1 muss eine Liste von %2 Zahlen von %3 bis %4 sein</translation>
    </message>
    <message>
        <source>%1 must run from the lowest to the highest value</source>
        <translation>%1 muss vom kleinsten zum größten Wert laufen</translation>
    </message>
    <message>
        <source>%1 has too many entries</source>
        <translation>%1 hat zu viele Einträge</translation>
    </message>
    <message>
        <source>%1 must be a list</source>
        <translation>%1 muss eine Liste sein</translation>
    </message>
    <message>
        <source>%1 must be a list of whole numbers</source>
        <translation>%1 muss eine Liste ganzer Zahlen sein</translation>
    </message>
    <message>
        <source>%1 must be a list of colours, as &quot;#f0962c&quot;</source>
        <translation>%1 muss eine Liste von Farben sein, wie „#f0962c“</translation>
    </message>
    <message>
        <source>%1 must be a colour, as &quot;#f0962c&quot;</source>
        <translation>%1 muss eine Farbe sein, wie „#f0962c“</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 darf nicht leer sein</translation>
    </message>
    <message>
        <source>%1 must be a list of names</source>
        <translation>%1 muss eine Liste von Namen sein</translation>
    </message>
    <message>
        <source>%1 must be a list of finite numbers or null</source>
        <translation>%1 muss eine Liste endlicher Zahlen oder null sein</translation>
    </message>
    <message>
        <source>%1 must be a list of words or null</source>
        <translation>%1 muss eine Liste von Wörtern oder null sein</translation>
    </message>
    <message>
        <source>%1 names the clip &quot;%2&quot;, which no template of the scene has; there are: %3</source>
        <translation>%1 nennt den Clip „%2“, den keine Vorlage der Szene hat; es gibt: %3</translation>
    </message>
    <message>
        <source>%1 names the slot &quot;%2&quot;, which no template of the scene has; there are: %3</source>
        <translation>%1 nennt den Slot „%2“, den keine Vorlage der Szene hat; es gibt: %3</translation>
    </message>
    <message>
        <source>places: &quot;%1&quot; (id %2) is too far away: positions lie from -1000000 to 1000000 metres</source>
        <translation>places: „%1“ (id %2) ist zu weit weg: Orte liegen zwischen -1000000 und 1000000 Metern</translation>
    </message>
    <message>
        <source>%1 must be a list of ids of places</source>
        <translation>%1 muss eine Liste von Nummern von Orten sein</translation>
    </message>
    <message>
        <source>paths: &quot;%1&quot; (id %2) names the place %3, which is not there</source>
        <translation>paths: „%1“ (id %2) nennt den Ort %3, den es nicht gibt</translation>
    </message>
    <message>
        <source>paths: &quot;%1&quot; (id %2) branches off to the path %3, which is not there</source>
        <translation>paths: „%1“ (id %2) zweigt zum Weg %3 ab, den es nicht gibt</translation>
    </message>
    <message>
        <source>%1 must be 30, 60 or 120</source>
        <translation>%1 muss 30, 60 oder 120 sein</translation>
    </message>
    <message>
        <source>The environment is nested more than %1 deep.</source>
        <translation>Die Umgebung ist mehr als %1 tief verschachtelt.</translation>
    </message>
    <message>
        <source>The environment has no &quot;%1&quot;: there are %2.</source>
        <translation>Die Umgebung hat kein „%1“: es gibt %2.</translation>
    </message>
    <message>
        <source>%1: the id %2 is not allowed</source>
        <translation>%1: die Nummer %2 ist nicht erlaubt</translation>
    </message>
    <message>
        <source>%1: the id %2 is given twice</source>
        <translation>%1: die Nummer %2 ist zweimal vergeben</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 muss ein Objekt sein</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>%1 has no &quot;%2&quot;: there are %3</source>
        <translation>%1 hat kein „%2“: es gibt %3</translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation>%1 muss true oder false sein</translation>
    </message>
    <message>
        <source>%1 must be a text</source>
        <translation>%1 muss ein Text sein</translation>
    </message>
    <message>
        <source>%1 must be three finite numbers</source>
        <translation>%1 muss aus drei endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>%1 must be a unit quaternion [x, y, z, w]</source>
        <translation>%1 muss ein Einheitsquaternion [x, y, z, w] sein</translation>
    </message>
    <message>
        <source>This is not a Crowdbrush scene (there is no &quot;format&quot;: &quot;%1&quot;). Models are brought in with Import, not opened.</source>
        <translation>Dies ist keine Szene von Crowdbrush (es gibt kein &quot;format&quot;: &quot;%1&quot;). Modelle werden importiert, nicht geöffnet.</translation>
    </message>
    <message>
        <source>Its &quot;version&quot; must be a whole number above zero; restore an older copy.</source>
        <translation>Ihre „version“ muss eine ganze Zahl größer als null sein; eine ältere Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>It was written by a newer Crowdbrush (file version %1, this program reads up to %2). Update Crowdbrush to open it.</source>
        <translation>Sie wurde von einem neueren Crowdbrush geschrieben (Dateiversion %1, dieses Programm liest bis %2). Zum Öffnen Crowdbrush aktualisieren.</translation>
    </message>
    <message>
        <source>%1 must be above zero and at most 4000000000</source>
        <translation>%1 muss größer als null und höchstens 4000000000 sein</translation>
    </message>
    <message>
        <source>%1 has more than %2 parts</source>
        <translation>%1 hat mehr als %2 Teile</translation>
    </message>
    <message>
        <source>%1 must be one of F3 to F10 or empty</source>
        <translation>%1 muss F3 bis F10 oder leer sein</translation>
    </message>
    <message>
        <source>%1 must be a list of pairs: an individual&apos;s id and a number from -1000000 to 1000000</source>
        <translation>%1 muss eine Liste von Paaren sein: die Nummer einer Figur und eine Zahl von -1000000 bis 1000000</translation>
    </message>
    <message>
        <source>%1 names the individual %2 twice</source>
        <translation>%1 nennt die Figur %2 zweimal</translation>
    </message>
    <message>
        <source>%1: there are more than %2</source>
        <translation>%1: es sind mehr als %2</translation>
    </message>
    <message>
        <source>tags: the tag %1 is given twice</source>
        <translation>tags: die Marke %1 ist zweimal vergeben</translation>
    </message>
    <message>
        <source>Drawing the %1 failed. %2</source>
        <translation>Das Zeichnen (%1) ist misslungen. %2</translation>
    </message>
    <message>
        <source>%1: let the name end in one of %2; it says what the picture is written as.</source>
        <translation>%1: Der Name muss auf eines davon enden: %2; danach richtet sich, als was das Bild geschrieben wird.</translation>
    </message>
    <message>
        <source>%1: the picture could not be made: %2. Try a smaller size, or another ending.</source>
        <translation>%1: Das Bild konnte nicht erzeugt werden: %2. Es mit einer kleineren Größe oder einer anderen Endung versuchen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Check the folder, its rights and the space on the disk.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Ordner, Rechte und freien Platz prüfen.</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The script was not saved; choose another place or free some room.</source>
        <translation>%1 konnte nicht geschrieben werden (%2). Das Skript wurde nicht gespeichert; einen anderen Ort wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>Standing still, since their paths cannot be walked: %1. Give them another path.</source>
        <translation>Stehen still, weil ihre Wege nicht begehbar sind: %1. Ihnen einen anderen Weg geben.</translation>
    </message>
    <message>
        <source>Path &quot;%1&quot; names a place that is not there any more; characters pass it over.</source>
        <translation>Der Weg „%1“ nennt einen Ort, den es nicht mehr gibt; Figuren übergehen ihn.</translation>
    </message>
    <message>
        <source>Place &quot;%1&quot; has no position or size; characters pass it over. Give it numbers.</source>
        <translation>Der Ort „%1“ hat keine Position oder Größe; Figuren übergehen ihn. Ihm Zahlen geben.</translation>
    </message>
    <message>
        <source>Path &quot;%1&quot; has no places: nobody can walk it. Add some.</source>
        <translation>Der Weg „%1“ hat keine Orte: Niemand kann ihn gehen. Orte hinzufügen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; repeats without any time passing: let it wait or play a clip. It was ended.</source>
        <translation>Die Regel „%1“ wiederholt sich, ohne dass Zeit vergeht: Sie warten oder einen Clip spielen lassen. Sie wurde beendet.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; changes a number that is not there any more. Choose another one.</source>
        <translation>Die Regel „%1“ ändert eine Zahl, die es nicht mehr gibt. Eine andere wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters appear at a place that is not there any more. Choose another one.</source>
        <translation>Die Regel „%1“ lässt Figuren an einem Ort erscheinen, den es nicht mehr gibt. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters follow a path that is not there any more. Choose another one.</source>
        <translation>Die Regel „%1“ lässt Figuren einem Weg folgen, den es nicht mehr gibt. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters leave at &quot;%2&quot;, but some do not get there: they stay. Move it, or choose another one.</source>
        <translation>Die Regel „%1“ lässt Figuren bei „%2“ gehen, aber einige kommen nicht hin: Sie bleiben. Ihn versetzen oder einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends more events than can be under way; further ones are dropped. It may be sending events that make it send again: give it a pause, or say how often at most.</source>
        <translation>Die Regel „%1“ sendet mehr Ereignisse, als unterwegs sein können; weitere entfallen. Vielleicht sendet sie Ereignisse, auf die hin sie wieder sendet: Ihr eine Pause geben oder sagen, wie oft höchstens.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters sit down, but the scene has no seats. Bring a stage with seats along.</source>
        <translation>Die Regel „%1“ lässt Figuren sich setzen, aber die Szene hat keine Sitze. Eine Bühne mit Sitzen hereinholen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; names a place that is not there any more. Choose another one.</source>
        <translation>Die Regel „%1“ nennt einen Ort, den es nicht mehr gibt. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to a place that is not there any more. Choose another one.</source>
        <translation>Die Regel „%1“ schickt Figuren zu einem Ort, den es nicht mehr gibt. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to places of a path that is not there any more, or has none. Choose another one.</source>
        <translation>Die Regel „%1“ schickt Figuren zu Orten eines Wegs, den es nicht mehr gibt oder der keine hat. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to places by a name that none has any more. Choose another one.</source>
        <translation>Die Regel „%1“ schickt Figuren zu Orten mit einem Namen, den keiner mehr hat. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; lets characters leave at an exit, but there is none: they stay. Paint one with the environment brush.</source>
        <translation>Die Regel „%1“ lässt Figuren an einem Ausgang gehen, aber es gibt keinen: Sie bleiben. Mit dem Umgebungspinsel einen malen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; sends characters to a place, but there is none. Paint one with the path brush.</source>
        <translation>Die Regel „%1“ schickt Figuren zu einem Ort, aber es gibt keinen. Mit dem Wegpinsel einen malen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; follows whoever sent the event, but it came from a brush, a cue or nobody. Let characters send it, or follow those with a tag.</source>
        <translation>Die Regel „%1“ folgt dem, der das Ereignis gesendet hat, aber es kam von einem Pinsel, einem Stichwort oder niemandem. Es von Figuren senden lassen oder denen mit einer Marke folgen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot; fires over and over for the same characters: events go round in a circle. Give it a pause, or say how often at most.</source>
        <translation>Die Regel „%1“ kommt für dieselben Figuren immer wieder: Ereignisse gehen im Kreis. Ihr eine Pause geben oder sagen, wie oft höchstens.</translation>
    </message>
    <message>
        <source>There is more for rules to do at once than a step has room for; characters act later, and events beyond half a million are dropped. Let rules send events to fewer characters, wait in between, or come less often.</source>
        <translation>Regeln haben auf einmal mehr zu tun, als in einen Schritt passt; Figuren handeln später, und Ereignisse jenseits einer halben Million entfallen. Regeln Ereignisse an weniger Figuren senden, dazwischen warten oder seltener kommen lassen.</translation>
    </message>
    <message>
        <source>Path &quot;%1&quot;: between &quot;%2&quot; and &quot;%3&quot; no way leads; characters go as near as they can. Move one of them, or lead the path around what is between.</source>
        <translation>Weg „%1“: Zwischen „%2“ und „%3“ kommt man nicht durch; Figuren gehen so nah heran wie möglich. Einen der beiden versetzen oder den Weg um das herumführen, was dazwischen liegt.</translation>
    </message>
    <message>
        <source>Path &quot;%1&quot;: between &quot;%2&quot; and &quot;%3&quot; something is in the way; characters go around it. Add places where they should go.</source>
        <translation>Weg „%1“: Zwischen „%2“ und „%3“ liegt etwas im Weg; Figuren gehen darum herum. Orte hinzufügen, wo sie gehen sollen.</translation>
    </message>
    <message>
        <source>Place &quot;%1&quot; is not on ground that characters can walk on; they go as near as they can. Move it.</source>
        <translation>Der Ort „%1“ liegt nicht auf begehbarem Boden; Figuren gehen so nah heran wie möglich. Ihn versetzen.</translation>
    </message>
    <message>
        <source>%1 character who should walk stand where no way leads to or from: on roofs or trees, in a basin, in the air. Put them on the nearest ground (Edit, Put on the Ground).</source>
        <translation>%1 Figur, die gehen soll, steht, wo kein Weg hin- oder wegführt: auf einem Dach oder Baum, in einem Becken, in der Luft. Sie auf den nächsten Boden stellen (Bearbeiten, Auf den Boden stellen).</translation>
    </message>
    <message>
        <source>%1 characters who should walk stand where no way leads to or from: on roofs or trees, in a basin, in the air. Put them on the nearest ground (Edit, Put on the Ground).</source>
        <translation>%1 Figuren, die gehen sollen, stehen, wo kein Weg hin- oder wegführt: auf Dächern oder Bäumen, in einem Becken, in der Luft. Sie auf den nächsten Boden stellen (Bearbeiten, Auf den Boden stellen).</translation>
    </message>
    <message>
        <source>There cannot be %1 steps a second; there are as many as usual. Choose a length in the menu Play.</source>
        <translation>%1 Schritte in der Sekunde sind nicht möglich; es sind so viele wie üblich. Im Menü „Abspielen“ eine Länge wählen.</translation>
    </message>
    <message>
        <source>Walkers that are not in the scene, or named twice. Left out: %1.</source>
        <translation>Gehende, die nicht in der Szene sind oder zweimal genannt werden. Ausgelassen: %1.</translation>
    </message>
    <message>
        <source>Event &quot;%1&quot; came with a number that is none, and is not sent. Give it another one.</source>
        <translation>Das Ereignis „%1“ kam mit einer Zahl, die keine ist, und wird nicht gesendet. Ihm eine andere geben.</translation>
    </message>
    <message>
        <source>Characters without a position, left out: %1. Delete them, or give them one.</source>
        <translation>Figuren ohne Position, ausgelassen: %1. Sie löschen oder ihnen eine geben.</translation>
    </message>
    <message>
        <source>There is no stage to walk on; characters walk on open ground.</source>
        <translation>Es gibt keine Bühne zum Begehen; Figuren gehen auf freiem Gelände.</translation>
    </message>
    <message>
        <source>The walkable surface was not built: it was cancelled.</source>
        <translation>Die Gehfläche wurde nicht ermittelt: abgebrochen.</translation>
    </message>
    <message>
        <source>Nothing of the stage can be walked on; characters walk on open ground. Check its size, which way is up, and how wide, tall and steep characters can walk (Environment panel).</source>
        <translation>Nichts an der Bühne ist begehbar; Figuren gehen auf freiem Gelände. Ihre Größe prüfen, wo oben ist, und wie breit, hoch und steil Figuren gehen können (Tafel „Umgebung“).</translation>
    </message>
    <message>
        <source>There is no workload &quot;%1&quot;: choose square, corridor, city or paths.</source>
        <translation>Es gibt keine Aufgabe „%1“: square, corridor, city oder paths wählen.</translation>
    </message>
    <message>
        <source>%1 is %2; it must lie from %3 to %4.</source>
        <translation>%1 ist %2; erlaubt ist %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 is none of the choices there are.</source>
        <translation>%1 ist keine der möglichen Angaben.</translation>
    </message>
    <message>
        <source>%1 runs from the lowest to the highest value.</source>
        <translation>%1 läuft vom kleinsten zum größten Wert.</translation>
    </message>
    <message>
        <source>%1 must be in ascending order.</source>
        <translation>%1 muss aufsteigend geordnet sein.</translation>
    </message>
    <message>
        <source>%1 must hold at least one colour.</source>
        <translation>%1 muss mindestens eine Farbe enthalten.</translation>
    </message>
    <message>
        <source>the temporary file holds something else than an undo step</source>
        <translation>die temporäre Datei enthält etwas anderes als einen rückgängig zu machenden Schritt</translation>
    </message>
    <message>
        <source>%1: no temporary file could be made (%2)</source>
        <translation>%1: es ließ sich keine temporäre Datei anlegen (%2)</translation>
    </message>
    <message>
        <source>the disk of the temporary file is nearly full</source>
        <translation>der Datenträger der temporären Datei ist fast voll</translation>
    </message>
    <message>
        <source>the temporary file could not be written (%1)</source>
        <translation>die temporäre Datei konnte nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>the temporary file could not be read (%1)</source>
        <translation>die temporäre Datei konnte nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the temporary file is shorter than it was</source>
        <translation>die temporäre Datei ist kürzer, als sie war</translation>
    </message>
    <message>
        <source>the temporary file does not hold what was written to it</source>
        <translation>die temporäre Datei enthält nicht, was in sie geschrieben wurde</translation>
    </message>
    <message>
        <source>there is no process to unpack it in</source>
        <translation>es gibt keinen Prozess, um sie zu entpacken</translation>
    </message>
    <message>
        <source>it takes too long to unpack</source>
        <translation>das Entpacken dauert zu lange</translation>
    </message>
    <message>
        <source>it unpacks to more than it says</source>
        <translation>entpackt ist es mehr, als angegeben</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>die Daten sind beschädigt</translation>
    </message>
    <message>
        <source>%1 animation keys are out of order or no numbers; they are left out.</source>
        <translation>%1 Animationsschlüssel sind außer der Reihe oder keine Zahlen; sie werden ausgelassen.</translation>
    </message>
    <message>
        <source>%1 is longer than an hour</source>
        <translation>%1 ist länger als eine Stunde</translation>
    </message>
    <message>
        <source>%1: the times of its keys are not single numbers</source>
        <translation>%1: die Zeiten der Schlüssel sind keine einzelnen Zahlen</translation>
    </message>
    <message>
        <source>%1: the animations have more than %2 numbers</source>
        <translation>%1: die Animationen haben mehr als %2 Zahlen</translation>
    </message>
    <message>
        <source>%1: it has %2 values of the wrong number or type for its %3 keys</source>
        <translation>%1: hat %2 Werte, deren Anzahl oder Typ nicht zu den %3 Schlüsseln passt</translation>
    </message>
    <message>
        <source>%1 is not the index of one of the file&apos;s %2</source>
        <translation>%1 ist kein Index eines der %2 der Datei</translation>
    </message>
    <message>
        <source>%1 is %2, but the file has only %3 %4</source>
        <translation>%1 ist %2, aber die Datei hat nur %3 %4</translation>
    </message>
    <message>
        <source>%1 is not a list of indices</source>
        <translation>%1 ist keine Liste von Indizes</translation>
    </message>
    <message>
        <source>%1 is %2, not a whole number from %3 to %4</source>
        <translation>%1 ist %2, keine ganze Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers</source>
        <translation>%1 ist keine Liste von %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 is not a list</source>
        <translation>%1 ist keine Liste</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 ist kein Objekt</translation>
    </message>
    <message>
        <source>%1 is no multiple of 4</source>
        <translation>%1 ist kein Vielfaches von 4</translation>
    </message>
    <message>
        <source>%1 is none that glTF 2.0 knows</source>
        <translation>%1 ist in glTF 2.0 nicht bekannt</translation>
    </message>
    <message>
        <source>%1 has more than %2 numbers</source>
        <translation>%1 hat mehr als %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 lacks its indices or values</source>
        <translation>%1 hat keine indices oder values</translation>
    </message>
    <message>
        <source>%1 is not an unsigned type</source>
        <translation>%1 ist kein Typ ohne Vorzeichen</translation>
    </message>
    <message>
        <source>%1 is missing or empty</source>
        <translation>%1 fehlt oder ist leer</translation>
    </message>
    <message>
        <source>%1 is not one of the file&apos;s %2 variants</source>
        <translation>%1 ist keine der %2 Varianten der Datei</translation>
    </message>
    <message>
        <source>%1 is not a list of one 4x4 matrix a joint</source>
        <translation>%1 ist keine Liste mit einer 4x4-Matrix je Gelenk</translation>
    </message>
    <message>
        <source>%1 is not one of the animation&apos;s %2 samplers</source>
        <translation>%1 ist keiner der %2 Sampler der Animation</translation>
    </message>
    <message>
        <source>%1 names a scene, but the file has none</source>
        <translation>%1 nennt eine Szene, aber die Datei hat keine</translation>
    </message>
    <message>
        <source>%1 is a child of both %2 and %3</source>
        <translation>%1 ist ein Kind von %2 und zugleich von %3</translation>
    </message>
    <message>
        <source>%1 is its own ancestor</source>
        <translation>%1 ist sein eigener Vorfahr</translation>
    </message>
    <message>
        <source>the file ends within the GLB header (%1 bytes)</source>
        <translation>die Datei endet mitten im GLB-Kopf (%1 Byte)</translation>
    </message>
    <message>
        <source>the GLB header says version %1; only glTF 2.0 can be read</source>
        <translation>der GLB-Kopf nennt Version %1; nur glTF 2.0 ist lesbar</translation>
    </message>
    <message>
        <source>the GLB header promises %1 bytes, the file has only %2</source>
        <translation>der GLB-Kopf verspricht %1 Byte, die Datei hat nur %2</translation>
    </message>
    <message>
        <source>%1 bytes after the end of the GLB are ignored.</source>
        <translation>%1 Byte nach dem Ende des GLB werden übergangen.</translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is %3 bytes long, but only %4 are left</source>
        <translation>GLB-Abschnitt %1 bei Byte %2 ist %3 Byte lang, aber nur %4 sind übrig</translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is not the JSON chunk</source>
        <translation>GLB-Abschnitt %1 bei Byte %2 ist nicht der JSON-Abschnitt</translation>
    </message>
    <message>
        <source>GLB chunk %1 at byte %2 is a second JSON chunk</source>
        <translation>GLB-Abschnitt %1 bei Byte %2 ist ein zweiter JSON-Abschnitt</translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation>eine FBX-Datei</translation>
    </message>
    <message>
        <source>a Wavefront OBJ file</source>
        <translation>eine Wavefront-OBJ-Datei</translation>
    </message>
    <message>
        <source>a Collada file</source>
        <translation>eine Collada-Datei</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>eine Blender-Datei</translation>
    </message>
    <message>
        <source>a USD file</source>
        <translation>eine USD-Datei</translation>
    </message>
    <message>
        <source>an Alembic file</source>
        <translation>eine Alembic-Datei</translation>
    </message>
    <message>
        <source>an STL file</source>
        <translation>eine STL-Datei</translation>
    </message>
    <message>
        <source>a PLY file</source>
        <translation>eine PLY-Datei</translation>
    </message>
    <message>
        <source>a BVH motion file</source>
        <translation>eine BVH-Bewegungsdatei</translation>
    </message>
    <message>
        <source>an X3D file</source>
        <translation>eine X3D-Datei</translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation>eine VRML-Datei</translation>
    </message>
    <message>
        <source>a 3DS file</source>
        <translation>eine 3DS-Datei</translation>
    </message>
    <message>
        <source>a VRM file of an unknown kind</source>
        <translation>eine VRM-Datei unbekannter Art</translation>
    </message>
    <message>
        <source>the data: URI has no comma</source>
        <translation>die data:-URI hat kein Komma</translation>
    </message>
    <message>
        <source>the data: URI is not valid base64</source>
        <translation>die data:-URI ist kein gültiges Base64</translation>
    </message>
    <message>
        <source>it is not a plain file</source>
        <translation>das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>it is larger than 1 GiB</source>
        <translation>die Datei ist größer als 1 GiB</translation>
    </message>
    <message>
        <source>it cannot be opened: %1</source>
        <translation>die Datei lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>it cannot be read to its end: %1</source>
        <translation>die Datei lässt sich nicht bis zum Ende lesen: %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>this is %1, which Crowdbrush does not read. Convert it in Blender: %2, then File &gt; Export &gt; glTF 2.0 (.glb)</source>
        <translation>das ist %1, die Crowdbrush nicht liest. Sie in Blender umwandeln: %2, dann File &gt; Export &gt; glTF 2.0 (.glb)</translation>
    </message>
    <message>
        <source>this is neither a .glb (it does not begin with &quot;glTF&quot;) nor a .gltf (it does not begin with &quot;{&quot;)</source>
        <translation>das ist weder eine .glb (sie beginnt nicht mit „glTF“) noch eine .gltf (sie beginnt nicht mit „{“)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a path that begins at the file</source>
        <translation>„%1“ ist kein Pfad, der bei der Datei beginnt</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>it has %1 vertices, but its accessors say %2</source>
        <translation>es sind %1 Eckpunkte, aber die Accessoren nennen %2</translation>
    </message>
    <message>
        <source>it has %1 indices, but its accessor says %2</source>
        <translation>es sind %1 Indizes, aber der Accessor nennt %2</translation>
    </message>
    <message>
        <source>it lacks an attribute that the file wants of it, or has it with another number of components</source>
        <translation>ein Attribut, das die Datei verlangt, fehlt oder hat eine andere Zahl von Komponenten</translation>
    </message>
    <message>
        <source>%1 has no POSITION</source>
        <translation>%1 hat keine POSITION</translation>
    </message>
    <message>
        <source>%1 is nothing that a mesh has</source>
        <translation>%1 gibt es an einem Mesh nicht</translation>
    </message>
    <message>
        <source>%1: the compressed mesh cannot be read: %2</source>
        <translation>%1: das komprimierte Mesh lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>the program %1, which belongs beside crowdbrush, is not there; export the file without Draco compression</source>
        <translation>das Programm %1, das neben crowdbrush gehört, ist nicht da; die Datei ohne Draco-Kompression exportieren</translation>
    </message>
    <message>
        <source>%1.uri: %2; put that file there, or export the file as .glb, which holds all</source>
        <translation>%1.uri: %2; jene Datei dorthin legen oder als .glb exportieren, die alles enthält</translation>
    </message>
    <message>
        <source>%1.uri: %2</source>
        <translation>%1.uri: %2</translation>
    </message>
    <message>
        <source>%1 has no uri, and the file has no binary chunk for it</source>
        <translation>%1 hat keine uri, und die Datei hat keinen Binärabschnitt dafür</translation>
    </message>
    <message>
        <source>%1 should have %2 bytes, but only %3 are there</source>
        <translation>%1 soll %2 Byte haben, aber nur %3 sind da</translation>
    </message>
    <message>
        <source>%1: the buffers are larger than 1 GiB together</source>
        <translation>%1: die Puffer sind zusammen größer als 1 GiB</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>die Datei lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>what it hides is drawn</source>
        <translation>was sie verbirgt, wird gezeichnet</translation>
    </message>
    <message>
        <source>%1 is not read: %2.</source>
        <translation>%1 wird nicht gelesen: %2.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: %2. Check the name, the folder and its rights.</source>
        <translation>%1: %2. Namen, Ordner und Rechte prüfen.</translation>
    </message>
    <message>
        <source>%1: %2. Export it again as glTF 2.0 (.glb) from the program it was made in.</source>
        <translation>%1: %2. Die Datei aus dem Programm, in dem sie entstand, noch einmal als glTF 2.0 (.glb) exportieren.</translation>
    </message>
    <message>
        <source>it needs more memory than there is</source>
        <translation>der Speicher reicht dafür nicht aus</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>die Datei lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>it is not a picture that can be read (PNG, JPEG and WebP can)</source>
        <translation>das ist kein lesbares Bild (lesbar sind PNG, JPEG und WebP)</translation>
    </message>
    <message>
        <source>it cannot be decoded: %1</source>
        <translation>das Bild lässt sich nicht dekodieren: %1</translation>
    </message>
    <message>
        <source>it is too large (%1 x %2 pixels)</source>
        <translation>das Bild ist zu groß (%1 x %2 Pixel)</translation>
    </message>
    <message>
        <source>%1 has no PNG, JPEG or WebP picture and is left out.</source>
        <translation>%1 hat kein PNG-, JPEG- oder WebP-Bild und wird ausgelassen.</translation>
    </message>
    <message>
        <source>it has neither uri nor bufferView</source>
        <translation>es hat weder uri noch bufferView</translation>
    </message>
    <message>
        <source>the pictures are larger than 512 MiB together</source>
        <translation>die Bilder sind zusammen größer als 512 MiB</translation>
    </message>
    <message>
        <source>%1 is left out: %2.</source>
        <translation>%1 wird ausgelassen: %2.</translation>
    </message>
    <message>
        <source>Importing %1 was cancelled.</source>
        <translation>Das Importieren von %1 wurde abgebrochen.</translation>
    </message>
    <message>
        <source>it has no mesh, so that nobody made of it could be seen; export the file again together with the character&apos;s mesh, as triangles</source>
        <translation>die Datei hat kein Mesh, sodass niemand daraus zu sehen wäre; sie noch einmal zusammen mit dem Mesh der Figur exportieren, als Dreiecke</translation>
    </message>
    <message>
        <source>its scene has no triangles, so that nobody made of it could be seen; export the file again together with the character&apos;s mesh, as triangles</source>
        <translation>die Szene der Datei hat keine Dreiecke, sodass niemand daraus zu sehen wäre; sie noch einmal zusammen mit dem Mesh der Figur exportieren, als Dreiecke</translation>
    </message>
    <message>
        <source>it cannot be imported: %1</source>
        <translation>die Datei lässt sich nicht importieren: %1</translation>
    </message>
    <message>
        <source>%1 has another type or count than its fellows need</source>
        <translation>%1 hat einen anderen Typ oder eine andere Anzahl als die übrigen</translation>
    </message>
    <message>
        <source>%1: more than %2 instances</source>
        <translation>%1: mehr als %2 Instanzen</translation>
    </message>
    <message>
        <source>the JSON is nested more than %1 levels deep at byte %2</source>
        <translation>das JSON ist bei Byte %2 mehr als %1 Ebenen tief verschachtelt</translation>
    </message>
    <message>
        <source>the JSON has more than %1 values</source>
        <translation>das JSON hat mehr als %1 Werte</translation>
    </message>
    <message>
        <source>the JSON is not an object, so this is no glTF</source>
        <translation>das JSON ist kein Objekt, also ist dies kein glTF</translation>
    </message>
    <message>
        <source>the JSON cannot be read: %1</source>
        <translation>das JSON lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>The file has %1 levels of detail; the finest %2 are used.</source>
        <translation>Die Datei hat %1 Detailstufen; die feinsten %2 werden verwendet.</translation>
    </message>
    <message>
        <source>The file has %1 slots; only the first %2 can be tinted.</source>
        <translation>Die Datei hat %1 Slots; nur die ersten %2 lassen sich tönen.</translation>
    </message>
    <message>
        <source>Slot &quot;%1&quot;, variant &quot;%2&quot;: its picture lies by another set of coordinates than the default&apos;s, which is used for both.</source>
        <translation>Slot „%1“, Variante „%2“: Das Bild liegt nach anderen Koordinaten als das übliche; für beide gelten dessen Koordinaten.</translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: extras.tintMask is %2, which is no texture of the file.</source>
        <translation>Material „%1“: extras.tintMask ist %2, und das ist keine Textur der Datei.</translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: its emissive picture lies by another set of coordinates than its base colour, and is left out.</source>
        <translation>Material „%1“: Das leuchtende Bild liegt nach anderen Koordinaten als die Grundfarbe und wird ausgelassen.</translation>
    </message>
    <message>
        <source>%1: its nodes draw %2 primitives, more than %3</source>
        <translation>%1: die Knoten zeichnen %2 Primitive, mehr als %3</translation>
    </message>
    <message>
        <source>%1: more than %2 of them move meshes</source>
        <translation>%1: mehr als %2 davon bewegen Meshes</translation>
    </message>
    <message>
        <source>%1: the morph targets have more than %2 vertices</source>
        <translation>%1: die Morph-Ziele haben mehr als %2 Eckpunkte</translation>
    </message>
    <message>
        <source>%1: the scene has more than %2 vertices or %3 triangles</source>
        <translation>%1: die Szene hat mehr als %2 Eckpunkte oder %3 Dreiecke</translation>
    </message>
    <message>
        <source>Only the first %1 parts can be hidden; &quot;%2&quot; and those after it are always shown.</source>
        <translation>Nur die ersten %1 Teile lassen sich ausblenden; „%2“ und die folgenden sind immer zu sehen.</translation>
    </message>
    <message>
        <source>The file draws nothing: its scene has no triangles.</source>
        <translation>Die Datei zeichnet nichts: Ihre Szene hat keine Dreiecke.</translation>
    </message>
    <message>
        <source>%1 primitives are points or lines or have no positions; they are not drawn.</source>
        <translation>%1 Primitive sind Punkte oder Linien oder haben keine Positionen; sie werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Morph targets are not animated: the mesh keeps its resting shape.</source>
        <translation>Morph-Ziele werden nicht animiert: Das Mesh behält seine Ruheform.</translation>
    </message>
    <message>
        <source>%1: it asks for the mode &quot;%2&quot;, which Crowdbrush cannot read; export the file without compression</source>
        <translation>%1: verlangt den Modus „%2“, den Crowdbrush nicht lesen kann; die Datei ohne Kompression exportieren</translation>
    </message>
    <message>
        <source>%1: it asks for the filter &quot;%2&quot;, which Crowdbrush cannot read; export the file without compression</source>
        <translation>%1: verlangt den Filter „%2“, den Crowdbrush nicht lesen kann; die Datei ohne Kompression exportieren</translation>
    </message>
    <message>
        <source>%1 does not describe data of the file</source>
        <translation>%1 beschreibt keine Daten der Datei</translation>
    </message>
    <message>
        <source>%1: the file is larger than 1 GiB when it is unpacked</source>
        <translation>%1: die Datei ist entpackt größer als 1 GiB</translation>
    </message>
    <message>
        <source>%1: its compressed data is damaged, or newer than Crowdbrush; export the file without compression</source>
        <translation>%1: die komprimierten Daten sind beschädigt oder neuer als Crowdbrush; die Datei ohne Kompression exportieren</translation>
    </message>
    <message>
        <source>KHR_animation_pointer moves nodes alone; what else it animates stands still (%1).</source>
        <translation>KHR_animation_pointer bewegt nur Knoten; was es sonst animiert, steht still (%1).</translation>
    </message>
    <message>
        <source>The animation %1 moves nothing that Crowdbrush can move, and is left out.</source>
        <translation>Die Animation %1 bewegt nichts, was Crowdbrush bewegen kann, und wird ausgelassen.</translation>
    </message>
    <message>
        <source>%1 has the wrong type of accessor</source>
        <translation>%1 hat einen Accessor vom falschen Typ</translation>
    </message>
    <message>
        <source>%1 has %2 elements, but POSITION has %3</source>
        <translation>%1 hat %2 Elemente, aber POSITION hat %3</translation>
    </message>
    <message>
        <source>%1 has %2 values that are no numbers; they are read as 0.</source>
        <translation>%1 hat %2 Werte, die keine Zahlen sind; sie werden als 0 gelesen.</translation>
    </message>
    <message>
        <source>%1 does not fit POSITION</source>
        <translation>%1 passt nicht zu POSITION</translation>
    </message>
    <message>
        <source>%1: vertex %2 follows joint %3, but the skin has only %4</source>
        <translation>%1: Eckpunkt %2 folgt dem Gelenk %3, aber der Skin hat nur %4</translation>
    </message>
    <message>
        <source>%1: index %2 at position %3, but there are only %4 vertices</source>
        <translation>%1: Index %2 an Stelle %3, aber es gibt nur %4 Eckpunkte</translation>
    </message>
    <message>
        <source>%1 ends with %2 corners that make no triangle; they are left out.</source>
        <translation>%1 endet mit %2 Ecken, die kein Dreieck ergeben; sie werden ausgelassen.</translation>
    </message>
    <message>
        <source>%1 seats of the extras cannot be read and are left out.</source>
        <translation>%1 Sitze der extras sind nicht lesbar und werden ausgelassen.</translation>
    </message>
    <message>
        <source>%1 is missing, so this is no glTF 2.0 file</source>
        <translation>%1 fehlt, also ist dies keine Datei in glTF 2.0</translation>
    </message>
    <message>
        <source>%1 asks for glTF %2; only glTF 2.0 can be read</source>
        <translation>%1 verlangt glTF %2; nur glTF 2.0 ist lesbar</translation>
    </message>
    <message>
        <source>%1 is not a name</source>
        <translation>%1 ist kein Name</translation>
    </message>
    <message>
        <source>%1 demands the extension %2, which Crowdbrush cannot read; export the file without it</source>
        <translation>%1 verlangt die Erweiterung %2, die Crowdbrush nicht lesen kann; die Datei ohne sie exportieren</translation>
    </message>
    <message>
        <source>%1 are more than %2</source>
        <translation>%1: es sind mehr als %2</translation>
    </message>
    <message>
        <source>%1 reaches to byte %2, but %3 has only %4</source>
        <translation>%1 reicht bis Byte %2, aber %3 hat nur %4</translation>
    </message>
    <message>
        <source>It is %1 m large as it is; import it at scale %2.</source>
        <translation>Es misst, wie es ist, an der längsten Seite %1 m; es im Maßstab %2 importieren.</translation>
    </message>
    <message>
        <source>It seems to lie on its back: Z was up where it was made.</source>
        <translation>Die Figur scheint auf dem Rücken zu liegen: Wo sie entstand, war Z oben.</translation>
    </message>
    <message>
        <source>It seems to face another way than +Z; turn it by %1 degrees.</source>
        <translation>Die Figur scheint nicht nach +Z zu sehen; sie um %1 Grad drehen.</translation>
    </message>
    <message>
        <source>Its lowest point is %1 m from the ground; offset it by %2 m.</source>
        <translation>Ihr tiefster Punkt ist %1 m vom Boden entfernt; sie um %2 m versetzen.</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; unsaved work is not kept.</source>
        <translation>%1: Der Ordner ließ sich nicht anlegen; ungespeicherte Arbeit wird nicht bewahrt.</translation>
    </message>
    <message>
        <source>%1: could not be copied (%2). Make room there or choose another place, then try again.</source>
        <translation>%1 konnte nicht kopiert werden (%2). Dort Platz schaffen oder einen anderen Ort wählen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The scene was not saved. %1</source>
        <translation>Die Szene wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The scene was not saved; choose another place or free some room.</source>
        <translation>%1 konnte nicht geschrieben werden (%2). Die Szene wurde nicht gespeichert; einen anderen Ort wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>%1: is not a file; choose a .crowd file.</source>
        <translation>%1 ist keine Datei; eine .crowd-Datei wählen.</translation>
    </message>
    <message>
        <source>%1: could not be opened (%2). Check its name and that you may read it.</source>
        <translation>%1 konnte nicht geöffnet werden (%2). Namen und Leserechte prüfen.</translation>
    </message>
    <message>
        <source>%1: is larger than 1 GiB, too large for a scene.</source>
        <translation>%1 ist größer als 1 GiB, zu groß für eine Szene.</translation>
    </message>
    <message>
        <source>%1: could not be read to its end (%2).</source>
        <translation>%1 konnte nicht bis zum Ende gelesen werden (%2).</translation>
    </message>
    <message>
        <source>a list of three finite numbers</source>
        <translation>eine Liste von drei endlichen Zahlen</translation>
    </message>
    <message>
        <source>The file is damaged or was edited wrongly: %1. Correct this place in a text editor, or restore an older copy.</source>
        <translation>Die Datei ist beschädigt oder wurde falsch bearbeitet: %1. Diese Stelle in einem Texteditor berichtigen oder eine ältere Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>binary data is not allowed</source>
        <translation>Binärdaten sind nicht erlaubt</translation>
    </message>
    <message>
        <source>it ends too early, at %1</source>
        <translation>sie endet zu früh, bei %1</translation>
    </message>
    <message>
        <source>there is a number that is too large at %1</source>
        <translation>bei %1 steht eine zu große Zahl</translation>
    </message>
    <message>
        <source>it is not valid JSON at %1</source>
        <translation>bei %1 steht kein gültiges JSON</translation>
    </message>
    <message>
        <source>it is not valid JSON at %1: %2</source>
        <translation>bei %1 steht kein gültiges JSON: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands twice in the same object</source>
        <translation>„%1“ steht zweimal im selben Objekt</translation>
    </message>
    <message>
        <source>the file must hold a JSON object</source>
        <translation>die Datei muss ein JSON-Objekt enthalten</translation>
    </message>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>sie ist mehr als %1 tief verschachtelt</translation>
    </message>
    <message>
        <source>a single value of the right kind</source>
        <translation>ein einzelner Wert der richtigen Art</translation>
    </message>
    <message>
        <source>it holds more than %1 individuals</source>
        <translation>sie enthält mehr als %1 Figuren</translation>
    </message>
    <message>
        <source>it holds more than %1 values beside the individuals</source>
        <translation>sie enthält neben den Figuren mehr als %1 Werte</translation>
    </message>
    <message>
        <source>individuals.rows stands there twice</source>
        <translation>individuals.rows steht zweimal da</translation>
    </message>
    <message>
        <source>individuals.columns must be a list of names and stand before the rows</source>
        <translation>individuals.columns muss eine Liste von Namen sein und vor den Zeilen stehen</translation>
    </message>
    <message>
        <source>&quot;individuals&quot; with &quot;columns&quot; and &quot;rows&quot; is missing</source>
        <translation>„individuals“ mit „columns“ und „rows“ fehlt</translation>
    </message>
    <message>
        <source>It needs more memory than there is; close other programs and try again.</source>
        <translation>Der Speicher reicht dafür nicht aus; andere Programme schließen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Individual %1 has a %2 that is not a number; undo the last change or give it a new value.</source>
        <translation>Bei Figur %1 ist %2 keine Zahl; die letzte Änderung zurücknehmen oder einen neuen Wert setzen.</translation>
    </message>
    <message>
        <source>Individual %1 uses the template %2, which the scene does not have; undo the last change, or give the individual another template.</source>
        <translation>Figur %1 verwendet die Vorlage %2, die die Szene nicht hat; die letzte Änderung zurücknehmen oder der Figur eine andere Vorlage geben.</translation>
    </message>
    <message>
        <source>There is a value that cannot be saved: %1. Undo the last change or give it a new value.</source>
        <translation>Ein Wert lässt sich nicht speichern: %1. Die letzte Änderung zurücknehmen oder einen neuen Wert setzen.</translation>
    </message>
    <message>
        <source>a whole number that is not negative and not too large</source>
        <translation>eine ganze Zahl, nicht negativ und nicht zu groß</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a tint like &quot;#c04020ff&quot; (red, green, blue, strength)</source>
        <translation>eine Tönung wie „#c04020ff“ (Rot, Grün, Blau, Stärke)</translation>
    </message>
    <message>
        <source>sixteen hexadecimal digits</source>
        <translation>eine Folge von sechzehn Hexadezimalziffern</translation>
    </message>
    <message>
        <source>Individual %1 had the same seat as individual %2 and has none now; move one of them.</source>
        <translation>Figur %1 hatte denselben Sitz wie Figur %2 und hat jetzt keinen; eine der beiden versetzen.</translation>
    </message>
    <message>
        <source>%1 more shared a seat and have none now.</source>
        <translation>%1 weitere teilten sich einen Sitz und haben jetzt keinen.</translation>
    </message>
    <message>
        <source>%1 individual has a %2 outside %3 to %4; it is kept.</source>
        <translation>Bei %1 Figur liegt %2 außerhalb von %3 bis %4; der Wert bleibt.</translation>
    </message>
    <message>
        <source>%1 individuals have a %2 outside %3 to %4; it is kept.</source>
        <translation>Bei %1 Figuren liegt %2 außerhalb von %3 bis %4; die Werte bleiben.</translation>
    </message>
    <message>
        <source>%1 individuals followed a path that the file does not list; they follow none now.</source>
        <translation>Figuren, die einem Weg folgten, den die Datei nicht nennt, und jetzt keinem mehr folgen: %1.</translation>
    </message>
    <message>
        <source>a whole number above zero and at most 4000000000</source>
        <translation>eine ganze Zahl größer als null und höchstens 4000000000</translation>
    </message>
    <message>
        <source>two individuals have the id %1; give one of them another</source>
        <translation>zwei Figuren haben die Nummer %1; einer von ihnen eine andere geben</translation>
    </message>
    <message>
        <source>individual %1 uses the template %2, which the file does not list</source>
        <translation>Figur %1 verwendet die Vorlage %2, die die Datei nicht nennt</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The clip &quot;%1&quot; is not in the file any more; &quot;%2&quot; is played instead.</source>
        <translation>Der Clip „%1“ ist nicht mehr in der Datei; „%2“ spielt an seiner Stelle.</translation>
    </message>
    <message>
        <source>%1: the built-in models were not found. Install them beside the program or name their folder in CROWDBRUSH_RESOURCES.</source>
        <translation>%1: Die mitgelieferten Modelle wurden nicht gefunden. Sie neben dem Programm installieren oder ihren Ordner in CROWDBRUSH_RESOURCES nennen.</translation>
    </message>
    <message>
        <source>%1: there is no such built-in model. Locate a file instead.</source>
        <translation>%1: Ein solches mitgeliefertes Modell gibt es nicht. Stattdessen eine Datei suchen.</translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation>das ist ein Verweis, der auf sich selbst zurückführt</translation>
    </message>
    <message>
        <source>it is a folder, not a file</source>
        <translation>das ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>it is a pipe, not a file</source>
        <translation>das ist eine Pipe, keine Datei</translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation>das ist ein Socket, keine Datei</translation>
    </message>
    <message>
        <source>it is a device, not a file</source>
        <translation>das ist ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>The graphics driver offers no framebuffer of %1 by %2 pixels. Try a smaller picture.</source>
        <translation>Der Grafiktreiber bietet keinen Bildpuffer von %1 mal %2 Pixeln. Es mit einem kleineren Bild versuchen.</translation>
    </message>
    <message>
        <source>The graphics driver does not compile the shader %1 (%2): %3 A newer driver, or LIBGL_ALWAYS_SOFTWARE=1, may help.</source>
        <translation>Der Grafiktreiber übersetzt den Shader %1 nicht (%2): %3 Ein neuerer Treiber oder LIBGL_ALWAYS_SOFTWARE=1 kann helfen.</translation>
    </message>
    <message>
        <source>The graphics driver does not link the shader %1 (%2): %3 A newer driver, or LIBGL_ALWAYS_SOFTWARE=1, may help.</source>
        <translation>Der Grafiktreiber bindet den Shader %1 nicht (%2): %3 Ein neuerer Treiber oder LIBGL_ALWAYS_SOFTWARE=1 kann helfen.</translation>
    </message>
    <message>
        <source>Pictures without a window need EGL with device or surfaceless displays, and this system&apos;s libEGL has neither. Install Mesa (packages libegl1 and libgl1-mesa-dri).</source>
        <translation>Bilder ohne Fenster brauchen EGL mit Anzeigen von Geräten oder ohne Oberfläche, und die libEGL dieses Systems hat beides nicht. Mesa installieren (Pakete libegl1 und libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>None of this system&apos;s %1 EGL displays gives a context for OpenGL 3.3. Install a newer graphics driver, or Mesa&apos;s software one (package libgl1-mesa-dri).</source>
        <translation>Keine der %1 EGL-Anzeigen dieses Systems gibt einen Kontext für OpenGL 3.3 her. Einen neueren Grafiktreiber installieren oder den von Mesa, der in Software rechnet (Paket libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>None of this system&apos;s %1 EGL displays gives a context for OpenGL with display lists. Install a newer graphics driver, or Mesa&apos;s software one (package libgl1-mesa-dri).</source>
        <translation>Keine der %1 EGL-Anzeigen dieses Systems gibt einen Kontext für OpenGL mit Display-Listen her. Einen neueren Grafiktreiber installieren oder den von Mesa, der in Software rechnet (Paket libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>Drawing needs OpenGL 3.3; this context offers %1. Install a newer graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>Zeichnen braucht OpenGL 3.3; dieser Kontext bietet %1. Einen neueren Grafiktreiber installieren oder LIBGL_ALWAYS_SOFTWARE=1 setzen.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>The environment must be an object with lists of places, paths, groups, tags, rules, numbers and cues.</source>
        <translation>Die Umgebung muss ein Objekt mit Listen von places, paths, groups, tags, rules, numbers und cues sein.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version; update to use it.</source>
        <translation>%1 wurde von einer neueren Version geschrieben; aktualisieren Sie, um sie zu benutzen.</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation>%1 kann nicht benutzt werden: %2</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Eine Vorgabe braucht einen Namen.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There already is a preset %1.</source>
        <translation>Es gibt schon eine Vorgabe %1.</translation>
    </message>
    <message>
        <source>%1 cannot be removed: %2</source>
        <translation>%1 kann nicht entfernt werden: %2</translation>
    </message>
    <message>
        <source>Something else is being edited: finish or cancel (Esc) it first.</source>
        <translation>Erst beenden oder abbrechen (Esc), was gerade bearbeitet wird.</translation>
    </message>
    <message>
        <source>%1: a %2 file cannot be transparent. Let the name end in .png, or switch the transparency off.</source>
        <translation>%1: Eine Datei der Art %2 kann nicht durchsichtig sein. Der Name soll auf .png enden, oder die Durchsichtigkeit soll aus sein.</translation>
    </message>
    <message>
        <source>%1 is no brush preset. Choose a file that was saved as one.</source>
        <translation>%1 ist keine Pinselvorgabe. Wählen Sie eine Datei, die als solche gespeichert wurde.</translation>
    </message>
    <message>
        <source>%1 has no name. Write one into the file, as its member &quot;name&quot;.</source>
        <translation>%1 hat keinen Namen. Schreiben Sie einen als „name“ in die Datei.</translation>
    </message>
    <message>
        <source>%1: &quot;version&quot; must be %2. Copy the file again from where it came.</source>
        <translation>%1: „version“ muss %2 sein. Kopieren Sie die Datei noch einmal von dort, woher sie kam.</translation>
    </message>
    <message>
        <source>%1 is damaged: in line %2 it is no JSON any more. Copy the file again from where it came.</source>
        <translation>%1 ist beschädigt: Ab Zeile %2 ist es kein JSON mehr. Kopieren Sie die Datei noch einmal von dort, woher sie kam.</translation>
    </message>
    <message>
        <source>Place &quot;%1&quot;: %2 characters want to stand there; there is room for %3. Make it larger, or send them to several places.</source>
        <translation>Ort „%1“: %2 Figuren wollen dort stehen, Platz ist für %3. Vergrößern Sie ihn, oder schicken Sie sie zu mehreren Orten.</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list</source>
        <translation>Zeile %1 von %2 muss eine Liste sein</translation>
    </message>
    <message>
        <source>row %1 of %2, column &quot;%3&quot;: it must be %4</source>
        <translation>Zeile %1 von %2, Spalte „%3“: Hierher gehört %4</translation>
    </message>
    <message>
        <source>row %1 of %2 must have %3 values, one for each column</source>
        <translation>Zeile %1 von %2 muss %3 Werte haben, einen für jede Spalte</translation>
    </message>
    <message>
        <source>%1.rows stands there twice</source>
        <translation>%1.rows steht zweimal da</translation>
    </message>
    <message>
        <source>%1.ids must be ascending numbers like &quot;1-7,9&quot; and stand before the rows</source>
        <translation>%1.ids müssen aufsteigende Nummern wie „1-7,9“ sein und vor den Zeilen stehen</translation>
    </message>
    <message>
        <source>%1.columns must be a list of names and stand before the rows</source>
        <translation>%1.columns muss eine Liste von Namen sein und vor den Zeilen stehen</translation>
    </message>
    <message>
        <source>%1 must have as many rows as ids: %2</source>
        <translation>%1 muss so viele Zeilen wie Nummern haben: %2</translation>
    </message>
    <message>
        <source>%1.columns must be a list of names that begins with &quot;id&quot;</source>
        <translation>%1.columns muss eine Liste von Namen sein, die mit „id“ beginnt</translation>
    </message>
    <message>
        <source>%1.columns names &quot;%2&quot; twice</source>
        <translation>%1.columns nennt „%2“ zweimal</translation>
    </message>
    <message>
        <source>%1.columns lacks &quot;%2&quot;</source>
        <translation>In %1.columns fehlt „%2“</translation>
    </message>
    <message>
        <source>For %1 of them the template is gone.</source>
        <translation>Bei %1 von ihnen ist die Vorlage nicht mehr da.</translation>
    </message>
    <message>
        <source>For %1 of them the path is gone.</source>
        <translation>Bei %1 von ihnen ist der Weg nicht mehr da.</translation>
    </message>
    <message>
        <source>For %1 of them the seat is taken: they stay where they are.</source>
        <translation>Bei %1 von ihnen ist der Sitz besetzt: Sie bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>For %1 of them there is no clip &quot;%2&quot;: they keep theirs.</source>
        <translation>Bei %1 von ihnen gibt es keine Animation „%2“: Sie behalten ihre.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the state is not there. Choose another one.</source>
        <translation>Regel „%1“: Den Zustand gibt es nicht. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the value of a feature is not there. Choose another one.</source>
        <translation>Regel „%1“: Der Wert eines Merkmals ist nicht da. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>%1 holds no features. Choose a file that was saved from the panel Features.</source>
        <translation>%1 enthält keine Merkmale. Eine Datei wählen, die aus dem Bedienfeld „Merkmale“ gespeichert wurde.</translation>
    </message>
    <message>
        <source>There are as many values of features as there can be.</source>
        <translation>Mehr Werte von Merkmalen kann es nicht geben.</translation>
    </message>
    <message>
        <source>A scene has at most %1 features. Remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Merkmale. Erst eines entfernen.</translation>
    </message>
    <message>
        <source>%1: a kind or a value has no name</source>
        <translation>%1: Ein Merkmal oder ein Wert hat keinen Namen</translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; is given twice</source>
        <translation>%1: Der Name „%2“ ist zweimal vergeben</translation>
    </message>
    <message>
        <source>the id of an individual, a whole number above zero</source>
        <translation>die Kennung einer Figur, eine ganze Zahl über null</translation>
    </message>
    <message>
        <source>the id of a kind of relation, from 1 to 64</source>
        <translation>die Kennung einer Beziehungsart, von 1 bis 64</translation>
    </message>
    <message>
        <source>a number from 0 to 1</source>
        <translation>eine Zahl von 0 bis 1</translation>
    </message>
    <message>
        <source>relations.columns must stand before the rows, once, and be %1</source>
        <translation>relations.columns muss vor den Zeilen stehen, einmal, und %1 sein</translation>
    </message>
    <message>
        <source>%1 relations are left out: they are of individuals or kinds that the scene has not, or of somebody to himself</source>
        <translation>%1 Beziehungen sind ausgelassen: sie gehören zu Figuren oder Arten, die die Szene nicht hat, oder verbinden jemanden mit sich selbst</translation>
    </message>
    <message>
        <source>%1 relations stood there twice: the last ones count</source>
        <translation>%1 Beziehungen standen doppelt da: die letzten zählen</translation>
    </message>
    <message>
        <source>it holds more than %1 relations</source>
        <translation>sie enthält mehr als %1 Beziehungen</translation>
    </message>
    <message>
        <source>%1: a kind has no name</source>
        <translation>%1: eine Art hat keinen Namen</translation>
    </message>
    <message>
        <source>%1 must be an object with columns and rows</source>
        <translation>%1 muss ein Objekt mit „columns“ und „rows“ sein</translation>
    </message>
    <message>
        <source>Rule &quot;%1&quot;: the light is not there. Choose another one.</source>
        <translation>Regel „%1“: Das Licht gibt es nicht. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>People cannot be coloured by “%1”. There are: %2.</source>
        <translation>Nach „%1“ können Figuren nicht gefärbt werden. Es gibt: %2.</translation>
    </message>
    <message>
        <source>An orthographic camera has no lens: everything is sharp. Take a camera with perspective, or leave out depth of field.</source>
        <translation>Eine orthographische Kamera hat keine Linse: Alles ist scharf. Wählen Sie eine perspektivische Kamera, oder lassen Sie die Schärfentiefe weg.</translation>
    </message>
    <message>
        <source>The distance of focus must be from 0.01 to 1000000 metres.</source>
        <translation>Die Entfernung der Schärfe muss zwischen 0,01 und 1000000 Metern liegen.</translation>
    </message>
    <message>
        <source>The f-stop must be from 0.01 to 1000; the smaller, the less is sharp.</source>
        <translation>Die Blendenzahl muss zwischen 0,01 und 1000 liegen; je kleiner, desto weniger ist scharf.</translation>
    </message>
    <message>
        <source>The picture was stopped.</source>
        <translation>Das Bild wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 holds no looks. Choose a file that was saved from the panel Looks.</source>
        <translation>%1 enthält keine Looks. Wählen Sie eine Datei, die aus dem Bedienfeld Looks gespeichert wurde.</translation>
    </message>
    <message>
        <source>A scene has at most %1 looks: remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Looks: Entfernen Sie zuerst einen.</translation>
    </message>
    <message>
        <source>%1 is that of another look</source>
        <translation>%1 ist der eines anderen Looks</translation>
    </message>
    <message>
        <source>%1: a scene has at most %2 looks</source>
        <translation>%1: Eine Szene hat höchstens %2 Looks</translation>
    </message>
    <message>
        <source>There is no look &quot;%1&quot;; there are: %2.</source>
        <translation>Es gibt keinen Look „%1“; es gibt: %2.</translation>
    </message>
    <message>
        <source>Colours by &quot;%1&quot; are of the look &quot;property&quot;, not of &quot;%2&quot;: leave one of the two out.</source>
        <translation>Farben nach „%1“ gehören zum Look „property“, nicht zu „%2“: Lassen Sie eines der beiden weg.</translation>
    </message>
    <message>
        <source>Material &quot;%1&quot;: its normal map lies by another set of coordinates than its base colour, and is left out.</source>
        <translation>Material „%1“: Die Normalmap liegt nach anderen Koordinaten als die Grundfarbe und wird ausgelassen.</translation>
    </message>
    <message>
        <source>%1: let the name end in one of %2; it says what the movie is written as.</source>
        <translation>%1: Lassen Sie den Namen auf eines von %2 enden; das sagt, als was der Film geschrieben wird.</translation>
    </message>
    <message>
        <source>%1 is no file: give the movie another name.</source>
        <translation>%1 ist keine Datei: Geben Sie dem Film einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: movies are made by ffmpeg, which cannot be started (%2). Install the package ffmpeg, or write single pictures.</source>
        <translation>%1: Filme macht ffmpeg, und das lässt sich nicht starten (%2). Installieren Sie das Paket ffmpeg, oder schreiben Sie einzelne Bilder.</translation>
    </message>
    <message>
        <source>%1: the movie could not be made, ffmpeg has ended: %2. Check the space on the disk, or choose another kind of file.</source>
        <translation>%1: Der Film konnte nicht gemacht werden, ffmpeg hat geendet: %2. Prüfen Sie den Platz auf dem Datenträger, oder wählen Sie eine andere Art von Datei.</translation>
    </message>
    <message>
        <source>The movie was cancelled.</source>
        <translation>Der Film wurde abgebrochen.</translation>
    </message>
    <message>
        <source>What was played at %1 s is not known any more. Play it again, or begin the movie later.</source>
        <translation>Was bei %1 s abgespielt wurde, ist nicht mehr bekannt. Spielen Sie es noch einmal ab, oder beginnen Sie den Film später.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline recalls a state that is not there. Choose another one for that mark.</source>
        <translation>Bei %1 Sekunden ruft die Zeitleiste einen Zustand ab, den es nicht gibt. Wählen Sie für diese Zeitmarke einen anderen.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline calls the cue “%2”, which speaks to the selected: the mark names nobody. Let the cue reach everybody, or a tag.</source>
        <translation>Bei %1 Sekunden gibt die Zeitleiste das Stichwort „%2“, das den Ausgewählten gilt: die Zeitmarke nennt niemanden. Lassen Sie das Stichwort allen gelten oder einer Marke.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline calls a cue that is not there. Choose another one for that mark.</source>
        <translation>Bei %1 Sekunden gibt die Zeitleiste ein Stichwort, das es nicht gibt. Wählen Sie für diese Zeitmarke ein anderes.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline speaks to characters of whom none is there any more. Remove that mark.</source>
        <translation>Bei %1 Sekunden spricht die Zeitleiste Figuren an, von denen keine mehr da ist. Entfernen Sie diese Zeitmarke.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline sends an event without a name. Choose one for that mark.</source>
        <translation>Bei %1 Sekunden sendet die Zeitleiste ein Ereignis ohne Namen. Wählen Sie eines für diese Zeitmarke.</translation>
    </message>
    <message>
        <source>There is no pass &quot;%1&quot;. There are: %2.</source>
        <translation>Es gibt keine Ebene „%1“. Es gibt: %2.</translation>
    </message>
    <message>
        <source>The graphics driver offers no framebuffer of numbers of %1 by %2 pixels. Try a smaller picture.</source>
        <translation>Der Grafiktreiber bietet keinen Bildspeicher für Zahlen mit %1 mal %2 Pixeln. Versuchen Sie ein kleineres Bild.</translation>
    </message>
    <message>
        <source>%1 by %2 pixels are too many for passes, whose numbers take much memory: at most 40 million. Choose a smaller size.</source>
        <translation>%1 mal %2 Pixel sind zu viele für Ebenen, deren Zahlen viel Speicher brauchen: höchstens 40 Millionen. Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline wants the camera “%2”, which is not there. Choose another one for that mark.</source>
        <translation>Bei %1 Sekunden will die Zeitleiste die Kamera „%2“, die es nicht gibt. Wählen Sie für diese Zeitmarke eine andere.</translation>
    </message>
    <message>
        <source>At %1 seconds the camera is to travel along a path: choose one of at least two places for that mark.</source>
        <translation>Bei %1 Sekunden soll die Kamera einen Weg entlangfahren: Wählen Sie für diese Zeitmarke einen aus mindestens zwei Orten.</translation>
    </message>
    <message>
        <source>At %1 seconds the camera goes nowhere: choose a camera for that mark.</source>
        <translation>Bei %1 Sekunden fährt die Kamera nirgendwohin: Wählen Sie für diese Zeitmarke eine Kamera.</translation>
    </message>
    <message>
        <source>%1: a movie cannot be transparent. Choose numbered pictures, or switch the transparency off.</source>
        <translation>%1: Ein Film kann nicht durchsichtig sein. Wählen Sie nummerierte Bilder, oder schalten Sie die Durchsichtigkeit aus.</translation>
    </message>
    <message>
        <source>At %1 seconds the timeline moves the camera twice: only the later mark is seen. Move one of them, or remove it.</source>
        <translation>Bei %1 Sekunden bewegt die Zeitleiste die Kamera zweimal: Nur die spätere Zeitmarke ist zu sehen. Verschieben Sie eine davon, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>%1: is damaged.</source>
        <translation>%1: ist beschädigt.</translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; cannot be read at %2 s: its file is damaged. Fetch it from a copy.</source>
        <translation>Der Take „%1“ lässt sich bei %2 s nicht lesen: Seine Datei ist beschädigt. Holen Sie sie aus einer Kopie.</translation>
    </message>
    <message>
        <source>The take cannot be read: its file is damaged. Fetch it from a copy.</source>
        <translation>Der Take lässt sich nicht lesen: Seine Datei ist beschädigt. Holen Sie sie aus einer Kopie.</translation>
    </message>
    <message>
        <source>The take is too short to take a part of it again.</source>
        <translation>Der Take ist zu kurz, um einen Teil davon neu zu spielen.</translation>
    </message>
    <message>
        <source>Nobody is chosen who could be taken again.</source>
        <translation>Es ist niemand gewählt, der neu spielen könnte.</translation>
    </message>
    <message>
        <source>A stretch of time has a beginning and an end.</source>
        <translation>Ein Zeitraum hat einen Anfang und ein Ende.</translation>
    </message>
    <message>
        <source>The stretch that is to be taken again lies outside the take, or is empty. Choose another one on the timeline.</source>
        <translation>Der Zeitraum, der neu gespielt werden soll, liegt außerhalb des Takes oder ist leer. Wählen Sie einen anderen auf der Zeitleiste.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The take was not kept; free some room or save the project elsewhere.</source>
        <translation>%1: konnte nicht geschrieben werden (%2). Der Take wurde nicht behalten; schaffen Sie Platz oder speichern Sie das Projekt anderswo.</translation>
    </message>
    <message>
        <source>%1: is damaged or no take. Keep the take once more, or fetch the file from a copy.</source>
        <translation>%1: ist beschädigt oder kein Take. Behalten Sie den Take noch einmal, oder holen Sie die Datei aus einer Kopie.</translation>
    </message>
    <message>
        <source>Nothing has been played yet: there is no take to keep. Play first.</source>
        <translation>Es wurde noch nichts gespielt: Es gibt keinen Take zu behalten. Spielen Sie zuerst ab.</translation>
    </message>
    <message>
        <source>the folder could not be made</source>
        <translation>der Ordner konnte nicht angelegt werden</translation>
    </message>
    <message>
        <source>%1: is of a newer version of Crowdbrush, or of another kind of machine. Open it there.</source>
        <translation>%1: ist von einer neueren Version von Crowdbrush oder von einer anderen Art von Rechner. Öffnen Sie sie dort.</translation>
    </message>
    <message>
        <source>The motion of the take &quot;%1&quot; is missing: put its file %2 into the folder %3, or delete the take.</source>
        <translation>Die Bewegung des Takes „%1“ fehlt: Legen Sie seine Datei %2 in den Ordner %3, oder löschen Sie den Take.</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). The take &quot;%3&quot; would be lost; choose another place or free some room.</source>
        <translation>%1: konnte nicht geschrieben werden (%2). Der Take „%3“ ginge verloren; wählen Sie einen anderen Ort oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>There are more takes than %1: the others are not opened. Delete some, save and open the project again.</source>
        <translation>Es gibt mehr als %1 Takes: Die übrigen werden nicht geöffnet. Löschen Sie einige, speichern Sie und öffnen Sie das Projekt erneut.</translation>
    </message>
    <message>
        <source>%1: is not a file; choose a .take file.</source>
        <translation>%1: ist keine Datei; wählen Sie eine .take-Datei.</translation>
    </message>
    <message>
        <source>%1: is cut off. Keep the take once more, or fetch the file from a copy.</source>
        <translation>%1: ist abgeschnitten. Behalten Sie den Take noch einmal, oder holen Sie die Datei aus einer Kopie.</translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; has %2 edits by hand; there can be %3. Delete some.</source>
        <translation>Der Take „%1“ hat %2 Änderungen von Hand; es können %3 sein. Löschen Sie einige.</translation>
    </message>
    <message>
        <source>What is done to people by hand is a list of objects.</source>
        <translation>Was mit Figuren von Hand geschieht, ist eine Liste von Objekten.</translation>
    </message>
    <message>
        <source>A take has at most %1 edits by hand, not %2.</source>
        <translation>Ein Take hat höchstens %1 Änderungen von Hand, nicht %2.</translation>
    </message>
    <message>
        <source>The takes &quot;%1&quot; and &quot;%2&quot; have no time in common.</source>
        <translation>Die Takes „%1“ und „%2“ haben keine gemeinsame Zeit.</translation>
    </message>
    <message>
        <source>%1 has no room for passes: let the name end in .exr or .png.</source>
        <translation>%1 hat keinen Platz für Ebenen: Lassen Sie den Namen auf .exr oder .png enden.</translation>
    </message>
    <message>
        <source>%1: only OpenEXR has room for the pass &quot;%2&quot;. Let the name end in .exr, or leave that pass away.</source>
        <translation>%1: Nur OpenEXR hat Platz für die Ebene „%2“. Lassen Sie den Namen auf .exr enden, oder lassen Sie diese Ebene weg.</translation>
    </message>
    <message>
        <source>%1: a picture has at most %2 pixels a side, not %3. Choose a smaller size.</source>
        <translation>%1: Ein Bild hat höchstens %2 Pixel je Seite, nicht %3. Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>%1: a %2 file has at most %3 pixels a side, not %4. Let the name end in .png, or choose a smaller size.</source>
        <translation>%1: Eine %2-Datei hat höchstens %3 Pixel je Seite, nicht %4. Lassen Sie den Namen auf .png enden, oder wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>%1 is a quaternion (w, x, y, z) of length 1; (1, 0, 0, 0) does not turn. The length of what was given is %2.</source>
        <translation>%1 ist eine Quaternion (w, x, y, z) der Länge 1; (1, 0, 0, 0) dreht nicht. Die Länge der angegebenen ist %2.</translation>
    </message>
    <message>
        <source>It is built like a person and %1 m tall; import it at scale %2, or at 1 if it is a giant.</source>
        <translation>Es ist wie ein Mensch gebaut und %1 m groß; importieren Sie es im Maßstab %2, oder in 1, wenn es ein Riese ist.</translation>
    </message>
    <message>
        <source>It is named &quot;%1&quot; and %2 m large; import it at scale %3, or at 1 if it is meant to be so.</source>
        <translation>Es heißt „%1“ und misst an der längsten Seite %2 m; importieren Sie es im Maßstab %3, oder in 1, wenn es so gemeint ist.</translation>
    </message>
    <message>
        <source>It is named &quot;%1&quot; and %2 m large: scale %3 would make it as large as one.</source>
        <translation>Es heißt „%1“ und misst an der längsten Seite %2 m: Im Maßstab %3 wäre es so groß wie ein echtes.</translation>
    </message>
    <message>
        <source>%1 must be a list of [x, y, z], metres from the position: 2 or more of a line, 3 or more of an area, at most %2, none farther off than %3</source>
        <translation>%1 muss eine Liste von [x, y, z] sein, Meter von der Position aus: 2 oder mehr einer Linie, 3 oder mehr einer Fläche, höchstens %2, keine weiter weg als %3</translation>
    </message>
    <message>
        <source>%1.%2</source>
        <translation>%1,%2</translation>
    </message>
    <message>
        <source>The memory of the graphics card does not suffice for this picture, however coarse. Choose a smaller picture, remove templates from the scene, or close other programs.</source>
        <translation>Der Speicher der Grafikkarte reicht für dieses Bild nicht, wie grob auch immer. Wählen Sie ein kleineres Bild, entfernen Sie Vorlagen aus der Szene, oder schließen Sie andere Programme.</translation>
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
    <name>Paths</name>
    <message>
        <source>Path %1</source>
        <translation>Weg %1</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Ort %1</translation>
    </message>
</context>
<context>
    <name>PicturePasses</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Individual</source>
        <translation>Figur</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Cryptomatte</source>
        <translation>Cryptomatte</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
</context>
<context>
    <name>PlaceCorners</name>
    <message>
        <source>Move a corner</source>
        <translation>Eine Ecke verschieben</translation>
    </message>
    <message>
        <source>Take out a corner</source>
        <translation>Eine Ecke herausnehmen</translation>
    </message>
    <message>
        <source>A line keeps two corners, an area three.</source>
        <translation>Eine Linie behält zwei Ecken, eine Fläche drei.</translation>
    </message>
    <message>
        <source>Insert a corner</source>
        <translation>Eine Ecke einfügen</translation>
    </message>
</context>
<context>
    <name>PlaceHandles</name>
    <message>
        <source>Resize a place</source>
        <translation>Größe eines Orts ändern</translation>
    </message>
    <message numerus="yes">
        <source>Move %n place(s)</source>
        <translation>
            <numerusform>Einen Ort versetzen</numerusform>
            <numerusform>%n Orte versetzen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Select two places or more first, in the order to walk them.</source>
        <translation>Zuerst zwei oder mehr Orte auswählen, in der Reihenfolge, in der sie gegangen werden.</translation>
    </message>
    <message>
        <source>Make a path</source>
        <translation>Einen Weg machen</translation>
    </message>
    <message>
        <source>Resize places</source>
        <translation>Größe von Orten ändern</translation>
    </message>
    <message>
        <source>%1: characters stop at its last place.</source>
        <translation>%1: Figuren bleiben am letzten Ort stehen.</translation>
    </message>
    <message>
        <source>%1: characters go round and round.</source>
        <translation>%1: Figuren gehen immer im Kreis.</translation>
    </message>
    <message>
        <source>%1: characters jump from its last place to its first.</source>
        <translation>%1: Figuren springen vom letzten Ort zum ersten.</translation>
    </message>
    <message>
        <source>Insert a place</source>
        <translation>Einen Ort einfügen</translation>
    </message>
    <message>
        <source>Take back a path of one place</source>
        <translation>Einen Weg aus nur einem Ort zurücknehmen</translation>
    </message>
    <message>
        <source>Take back a single corner</source>
        <translation>Eine einzelne Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>Two corners make a line: an area has three or more.</source>
        <translation>Zwei Ecken ergeben eine Linie: eine Fläche hat drei oder mehr.</translation>
    </message>
</context>
<context>
    <name>PlaceTool</name>
    <message>
        <source>Lead a path over a place</source>
        <translation>Einen Weg über einen Ort führen</translation>
    </message>
    <message>
        <source>Begin a path</source>
        <translation>Einen Weg beginnen</translation>
    </message>
    <message>
        <source>Add a place to a path</source>
        <translation>Einem Weg einen Ort hinzufügen</translation>
    </message>
    <message>
        <source>Close a path</source>
        <translation>Einen Weg schließen</translation>
    </message>
    <message>
        <source>Click: put it on the ground · + −: its size · V: move and resize</source>
        <translation>Klick: auf den Boden setzen · + −: Größe · V: versetzen und Größe ändern</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>The path is closed: characters go round.</source>
        <translation>Der Weg ist geschlossen: Man geht im Kreis.</translation>
    </message>
    <message>
        <source>Close the path</source>
        <translation>Den Weg schließen</translation>
    </message>
    <message>
        <source>Nothing to walk on there: the pointer is on the sky, or on something upright. Click on the ground beside it.</source>
        <translation>Dort ist nichts, worauf man gehen könnte: Der Zeiger ist auf dem Himmel oder auf etwas Senkrechtem. Klicken Sie auf den Boden daneben.</translation>
    </message>
    <message>
        <source>No way leads there from the place before: characters go as near as they can.</source>
        <translation>Vom Ort davor führt kein Weg dorthin: Figuren gehen so weit heran, wie sie können.</translation>
    </message>
    <message>
        <source>Something is in between: characters walk %1 m around it.</source>
        <translation>Etwas steht dazwischen: Figuren gehen %1 m darum herum.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Add: %1</source>
        <translation>Hinzufügen: %1</translation>
    </message>
    <message>
        <source>Click: add a corner · Drag: draw freely · Enter, Esc or double click: end it · on the first corner: close it · V: move corners</source>
        <translation>Klick: eine Ecke setzen · Ziehen: frei zeichnen · Eingabe, Esc oder Doppelklick: beenden · auf die erste Ecke: schließen · V: Ecken verschieben</translation>
    </message>
    <message>
        <source>Click: add a corner · Drag: draw freely · Enter, Esc or double click: end it · on the first corner: close it · + −: the width of a line · V: move corners</source>
        <translation>Klick: eine Ecke setzen · Ziehen: frei zeichnen · Eingabe, Esc oder Doppelklick: beenden · auf die erste Ecke: schließen · + −: Breite einer Linie · V: Ecken verschieben</translation>
    </message>
    <message>
        <source>Click: add a place to the path · + −: its size · on the first place: close the path · Enter or Esc: end it · Double click on a path: another place in it · V: move and resize places</source>
        <translation>Klick: dem Weg einen Ort hinzufügen · + −: seine Größe · auf dem ersten Ort: Weg schließen · Eingabe oder Esc: beenden · Doppelklick auf einen Weg: ein Ort mehr darin · V: Orte versetzen und ihre Größe ändern</translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
</context>
<context>
    <name>QuickCard</name>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>whom the cursor points at</source>
        <translation>auf wen der Zeiger zeigt</translation>
    </message>
    <message>
        <source>some in the circle, a second</source>
        <translation>einige im Kreis, je Sekunde</translation>
    </message>
    <message>
        <source>all whom the circle passes</source>
        <translation>alle, über die der Kreis fährt</translation>
    </message>
    <message>
        <source>all in a rectangle</source>
        <translation>alle in einem Rechteck</translation>
    </message>
    <message>
        <source>all inside a drawn line</source>
        <translation>alle in einer gezogenen Linie</translation>
    </message>
    <message>
        <source>the same value for all</source>
        <translation>für alle derselbe Wert</translation>
    </message>
    <message>
        <source>drawn for each of them</source>
        <translation>für jeden gezogen</translation>
    </message>
    <message>
        <source>from one end of the line to the other</source>
        <translation>von einem Ende der Linie zum anderen</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Crowdbrush at a glance</source>
        <translation>Crowdbrush auf einen Blick</translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>Bearbeiten</translation>
    </message>
</context>
<context>
    <name>ReadyNames</name>
    <message>
        <source>Above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Audience</source>
        <translation>Publikum</translation>
    </message>
    <message>
        <source>Back row</source>
        <translation>Hinterste Reihe</translation>
    </message>
    <message>
        <source>Beetles</source>
        <translation>Käfer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Eye to eye</source>
        <translation>Auge in Auge</translation>
    </message>
    <message>
        <source>Fountain</source>
        <translation>Brunnen</translation>
    </message>
    <message>
        <source>From the bridge</source>
        <translation>Von der Brücke</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>From the stage</source>
        <translation>Von der Bühne</translation>
    </message>
    <message>
        <source>From the top row</source>
        <translation>Aus der obersten Reihe</translation>
    </message>
    <message>
        <source>Horses</source>
        <translation>Pferde</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>Meadow</source>
        <translation>Wiese</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Spielfeld</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Tribüne</translation>
    </message>
    <message>
        <source>Whole theatre</source>
        <translation>Ganzes Theater</translation>
    </message>
    <message>
        <source>Floodlight</source>
        <translation>Flutlicht</translation>
    </message>
    <message>
        <source>Landing pad</source>
        <translation>Landeplatz</translation>
    </message>
    <message>
        <source>Left stand</source>
        <translation>Tribüne links</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Picnic</source>
        <translation>Picknick</translation>
    </message>
    <message>
        <source>Right stand</source>
        <translation>Tribüne rechts</translation>
    </message>
    <message>
        <source>Stage left</source>
        <translation>Bühne links</translation>
    </message>
    <message>
        <source>Stage right</source>
        <translation>Bühne rechts</translation>
    </message>
    <message>
        <source>Street lamp</source>
        <translation>Straßenlampe</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>Cheering</source>
        <translation>Jubel</translation>
    </message>
    <message>
        <source>Disappointed</source>
        <translation>Enttäuscht</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Stadt</translation>
    </message>
    <message>
        <source>Stadium</source>
        <translation>Stadion</translation>
    </message>
    <message>
        <source>Theatre</source>
        <translation>Theater</translation>
    </message>
</context>
<context>
    <name>RelationCommands</name>
    <message>
        <source>A scene has at most %1 relations: remove one first.</source>
        <translation>Eine Szene hat höchstens %1 Beziehungsarten: erst eine entfernen.</translation>
    </message>
    <message>
        <source>Add a relation</source>
        <translation>Beziehungsart hinzufügen</translation>
    </message>
    <message>
        <source>Remove a relation</source>
        <translation>Beziehungsart entfernen</translation>
    </message>
    <message>
        <source>It needs a name.</source>
        <translation>Sie braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is one of that name already.</source>
        <translation>Es gibt schon eine dieses Namens.</translation>
    </message>
    <message>
        <source>Change a relation</source>
        <translation>Beziehungsart ändern</translation>
    </message>
    <message>
        <source>It takes two: select whom to relate.</source>
        <translation>Dazu gehören zwei: auswählen, wer verbunden werden soll.</translation>
    </message>
    <message>
        <source>Those are too many: select at most %1 characters.</source>
        <translation>Das sind zu viele: höchstens %1 Figuren auswählen.</translation>
    </message>
    <message numerus="yes">
        <source>Relate %n character(s)</source>
        <translation>
            <numerusform>%n Figur verbinden</numerusform>
            <numerusform>%n Figuren verbinden</numerusform>
        </translation>
    </message>
    <message>
        <source>None of the selected has such a relation.</source>
        <translation>Keiner der Ausgewählten hat eine solche Beziehung.</translation>
    </message>
    <message>
        <source>Take relations away</source>
        <translation>Beziehungen lösen</translation>
    </message>
    <message>
        <source>Nobody has such a relation.</source>
        <translation>Niemand hat eine solche Beziehung.</translation>
    </message>
    <message>
        <source>Nobody is selected.</source>
        <translation>Niemand ist ausgewählt.</translation>
    </message>
    <message>
        <source>Nobody is selected: there is nobody to duplicate.</source>
        <translation>Niemand ist ausgewählt: es gibt niemanden zu duplizieren.</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n character(s)</source>
        <translation>
            <numerusform>%n Figur duplizieren</numerusform>
            <numerusform>%n Figuren duplizieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Relation %1</source>
        <translation>Beziehung %1</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is gone, and %n relations of that kind with it</source>
        <translation>
            <numerusform>„%1“ ist entfernt, mit %n Beziehung dieser Art</numerusform>
            <numerusform>„%1“ ist entfernt, mit %n Beziehungen dieser Art</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody else is related so to the selected.</source>
        <translation>Niemand sonst steht so in Beziehung zu den Ausgewählten.</translation>
    </message>
    <message numerus="yes">
        <source>%n more are selected now</source>
        <translation>
            <numerusform>%n weiterer ist jetzt ausgewählt</numerusform>
            <numerusform>%n weitere sind jetzt ausgewählt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No seat is free near %n of them: they stand</source>
        <translation>
            <numerusform>Kein Platz ist in der Nähe von %n von ihnen frei: sie steht</numerusform>
            <numerusform>Kein Platz ist in der Nähe von %n von ihnen frei: sie stehen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Relations</name>
    <message>
        <source>family</source>
        <translation>Familie</translation>
    </message>
    <message>
        <source>friends</source>
        <translation>Freunde</translation>
    </message>
    <message>
        <source>couple</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>Anführer</translation>
    </message>
    <message>
        <source>rivals</source>
        <translation>Rivalen</translation>
    </message>
</context>
<context>
    <name>RuleLog</name>
    <message>
        <source>%1–%2</source>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 s · %2 · %3</source>
        <translation>%1 s · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times</source>
        <translation>
            <numerusform>%1 · %n-mal</numerusform>
            <numerusform>%1 · %n-mal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times each</source>
        <translation>
            <numerusform>%1 · je %n-mal</numerusform>
            <numerusform>%1 · je %n-mal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n times in all</source>
        <translation>
            <numerusform>%1 · insgesamt %n-mal</numerusform>
            <numerusform>%1 · insgesamt %n-mal</numerusform>
        </translation>
    </message>
    <message>
        <source>character %1</source>
        <translation>Figur %1</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>characters %1</source>
        <translation>Figuren %1</translation>
    </message>
    <message>
        <source>a deleted rule</source>
        <translation>eine gelöschte Regel</translation>
    </message>
</context>
<context>
    <name>RuleSets</name>
    <message>
        <source>%1, seated</source>
        <translation>%1, sitzend</translation>
    </message>
    <message>
        <source>The wave runs on</source>
        <translation>Die Welle läuft weiter</translation>
    </message>
    <message>
        <source>Run at the number&apos;s speed</source>
        <translation>Im Tempo der Zahl laufen</translation>
    </message>
    <message>
        <source>Walk on</source>
        <translation>Weitergehen</translation>
    </message>
    <message>
        <source>Stop until told to walk</source>
        <translation>Anhalten, bis es weitergehen soll</translation>
    </message>
    <message>
        <source>Some stop and look around</source>
        <translation>Manche bleiben stehen und sehen sich um</translation>
    </message>
    <message>
        <source>Flee, tell others, leave</source>
        <translation>Fliehen, andere warnen, gehen</translation>
    </message>
    <message>
        <source>Wander about</source>
        <translation>Umherstreifen</translation>
    </message>
    <message>
        <source>Run from what startles</source>
        <translation>Weglaufen vor dem, was erschreckt</translation>
    </message>
    <message>
        <source>Applause spreads</source>
        <translation>Beifall breitet sich aus</translation>
    </message>
    <message>
        <source>Cheers spread</source>
        <translation>Jubel breitet sich aus</translation>
    </message>
    <message>
        <source>Line up</source>
        <translation>Anstellen</translation>
    </message>
    <message>
        <source>Be served, then leave</source>
        <translation>Bedient werden, dann gehen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Aufrücken</translation>
    </message>
    <message>
        <source>All calm down</source>
        <translation>Alle beruhigen sich</translation>
    </message>
    <message>
        <source>Waving spreads</source>
        <translation>Winken breitet sich aus</translation>
    </message>
    <message>
        <source>Sadness spreads</source>
        <translation>Trauer breitet sich aus</translation>
    </message>
    <message>
        <source>Boredom spreads</source>
        <translation>Langeweile breitet sich aus</translation>
    </message>
    <message>
        <source>Anger spreads</source>
        <translation>Wut breitet sich aus</translation>
    </message>
    <message>
        <source>Applause</source>
        <translation>Beifall</translation>
    </message>
    <message>
        <source>Cheers</source>
        <translation>Jubel</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Winken</translation>
    </message>
    <message>
        <source>Sad</source>
        <translation>Traurig</translation>
    </message>
    <message>
        <source>Bored</source>
        <translation>Gelangweilt</translation>
    </message>
    <message>
        <source>Angry</source>
        <translation>Wütend</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Laufen</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Panic</source>
        <translation>Panik</translation>
    </message>
    <message>
        <source>Startle</source>
        <translation>Erschrecken</translation>
    </message>
    <message>
        <source>Line up</source>
        <comment>cue</comment>
        <translation>Anstellen</translation>
    </message>
</context>
<context>
    <name>RuleTextsConte</name>
    <message>
        <source>(gone)</source>
        <translation>(fort)</translation>
    </message>
</context>
<context>
    <name>Rules</name>
    <message>
        <source>choose…</source>
        <translation>wählen …</translation>
    </message>
    <message>
        <source>(gone)</source>
        <translation>(fort)</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>choose clips…</source>
        <translation>Clips wählen …</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>any place</source>
        <translation>irgendein Ort</translation>
    </message>
    <message>
        <source>any path</source>
        <translation>irgendein Weg</translation>
    </message>
    <message>
        <source>When it begins</source>
        <translation>Wenn es beginnt</translation>
    </message>
    <message>
        <source>When someone’s clip is over</source>
        <translation>Wenn jemandes Clip vorbei ist</translation>
    </message>
    <message>
        <source>seated</source>
        <translation>sitzend</translation>
    </message>
    <message>
        <source>themselves</source>
        <translation>sich selbst</translation>
    </message>
    <message>
        <source>their group</source>
        <translation>ihre Gruppe</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>anhalten</translation>
    </message>
    <message>
        <source>walk on</source>
        <translation>weitergehen</translation>
    </message>
    <message>
        <source>at the event’s speed</source>
        <translation>im Tempo des Ereignisses</translation>
    </message>
    <message>
        <source>leave the scene</source>
        <translation>die Szene verlassen</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>The place is not there any more: choose another one.</source>
        <translation>Den Ort gibt es nicht mehr: einen anderen wählen.</translation>
    </message>
    <message>
        <source>The path is not there any more: choose another one.</source>
        <translation>Den Weg gibt es nicht mehr: einen anderen wählen.</translation>
    </message>
    <message>
        <source>Nobody has a clip to play: choose one.</source>
        <translation>Niemand hat einen Clip zum Spielen: einen wählen.</translation>
    </message>
    <message>
        <source>it begins</source>
        <translation>es beginnt</translation>
    </message>
    <message>
        <source>an event comes</source>
        <translation>ein Ereignis kommt</translation>
    </message>
    <message>
        <source>someone arrives at</source>
        <translation>jemand kommt an bei</translation>
    </message>
    <message>
        <source>someone enters</source>
        <translation>jemand betritt</translation>
    </message>
    <message>
        <source>someone leaves</source>
        <translation>jemand verlässt</translation>
    </message>
    <message>
        <source>a path ends</source>
        <translation>ein Weg endet</translation>
    </message>
    <message>
        <source>a clip is over</source>
        <translation>ein Clip ist vorbei</translation>
    </message>
    <message>
        <source>every so often</source>
        <translation>immer wieder</translation>
    </message>
    <message>
        <source>someone tagged is near</source>
        <translation>jemand mit Marke ist nahe</translation>
    </message>
    <message>
        <source>tagged</source>
        <translation>mit Marke</translation>
    </message>
    <message>
        <source>of template</source>
        <translation>von der Vorlage</translation>
    </message>
    <message>
        <source>inside place</source>
        <translation>innerhalb des Orts</translation>
    </message>
    <message>
        <source>walking path</source>
        <translation>auf dem Weg</translation>
    </message>
    <message>
        <source>by chance</source>
        <translation>durch Zufall</translation>
    </message>
    <message>
        <source>play a clip</source>
        <translation>einen Clip spielen</translation>
    </message>
    <message>
        <source>walk along a path</source>
        <translation>einen Weg gehen</translation>
    </message>
    <message>
        <source>go to a place</source>
        <translation>zu einem Ort gehen</translation>
    </message>
    <message>
        <source>run away</source>
        <translation>weglaufen</translation>
    </message>
    <message>
        <source>wait</source>
        <translation>warten</translation>
    </message>
    <message>
        <source>set the speed</source>
        <translation>das Tempo setzen</translation>
    </message>
    <message>
        <source>turn to</source>
        <translation>drehen zu</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>markieren</translation>
    </message>
    <message>
        <source>untag</source>
        <translation>Marke nehmen</translation>
    </message>
    <message>
        <source>send an event</source>
        <translation>ein Ereignis senden</translation>
    </message>
    <message>
        <source>those near</source>
        <translation>alle in der Nähe</translation>
    </message>
    <message>
        <source>those tagged</source>
        <translation>alle mit Marke</translation>
    </message>
    <message>
        <source>interrupts what they do</source>
        <translation>unterbricht, was sie tun</translation>
    </message>
    <message>
        <source>waits until they are free</source>
        <translation>wartet, bis sie frei sind</translation>
    </message>
    <message>
        <source>only who is free</source>
        <translation>nur wer frei ist</translation>
    </message>
    <message>
        <source>Audience Reactions</source>
        <translation>Reaktionen des Publikums</translation>
    </message>
    <message>
        <source>Stadium Wave</source>
        <translation>Welle im Stadion</translation>
    </message>
    <message>
        <source>Pedestrians</source>
        <translation>Fußgänger</translation>
    </message>
    <message>
        <source>Panic and Exit</source>
        <translation>Panik und Ausgang</translation>
    </message>
    <message>
        <source>Flock of Animals</source>
        <translation>Tierherde</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>, then </source>
        <translation>, dann </translation>
    </message>
    <message>
        <source>A condition asks for something that is not there: choose again.</source>
        <translation>Eine Bedingung fragt nach etwas, das es nicht gibt: neu wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: add something to do.</source>
        <translation>Sie tut noch nichts: etwas hinzufügen.</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>the event’s number</source>
        <translation>die Zahl des Ereignisses</translation>
    </message>
    <message>
        <source>sit on the nearest free seat</source>
        <translation>auf den nächsten freien Sitz setzen</translation>
    </message>
    <message>
        <source>stand up</source>
        <translation>aufstehen</translation>
    </message>
    <message>
        <source>The number is not there: make one below, under “Tags and numbers”.</source>
        <translation>Die Zahl gibt es nicht: Legen Sie unten unter „Marken und Zahlen“ eine an.</translation>
    </message>
    <message>
        <source>a speed is passed</source>
        <translation>ein Tempo überschritten wird</translation>
    </message>
    <message>
        <source>someone has stood for</source>
        <translation>jemand gestanden hat für</translation>
    </message>
    <message>
        <source>own number</source>
        <translation>eigene Zahl</translation>
    </message>
    <message>
        <source>event’s number</source>
        <translation>Zahl des Ereignisses</translation>
    </message>
    <message>
        <source>sit on a free seat</source>
        <translation>auf einen freien Sitz setzen</translation>
    </message>
    <message>
        <source>wait for an event</source>
        <translation>auf ein Ereignis warten</translation>
    </message>
    <message>
        <source>set a number</source>
        <translation>eine Zahl setzen</translation>
    </message>
    <message>
        <source>add to a number</source>
        <translation>zu einer Zahl hinzuzählen</translation>
    </message>
    <message>
        <source>appear at a place</source>
        <translation>an einem Ort erscheinen</translation>
    </message>
    <message>
        <source>yields to rules further up</source>
        <translation>weicht Regeln weiter oben</translation>
    </message>
    <message>
        <source>yields to any rule</source>
        <translation>weicht jeder Regel</translation>
    </message>
    <message>
        <source>yields to no rule</source>
        <translation>weicht keiner Regel</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>at</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>above</source>
        <translation>über</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>dieser Ort</translation>
    </message>
    <message>
        <source>the nearest</source>
        <translation>der nächste</translation>
    </message>
    <message>
        <source>the nearest free one</source>
        <translation>der nächste freie</translation>
    </message>
    <message>
        <source>the first free one</source>
        <translation>der erste freie</translation>
    </message>
    <message>
        <source>the one ahead, when free</source>
        <translation>der davor, wenn er frei ist</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>Warteschlange</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>How often it comes, against the others</source>
        <translation>Wie oft dies kommt, im Vergleich zu den anderen</translation>
    </message>
    <message>
        <source>all that can be</source>
        <translation>alle, die es gibt</translation>
    </message>
    <message>
        <source>The colour; how much of it beside</source>
        <translation>Die Farbe; daneben, wie viel davon</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>the place ahead gets free</source>
        <translation>der Ort davor frei wird</translation>
    </message>
    <message>
        <source>property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>go to someone</source>
        <translation>zu jemandem gehen</translation>
    </message>
    <message>
        <source>follow someone</source>
        <translation>jemandem folgen</translation>
    </message>
    <message>
        <source>look at</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>change a property</source>
        <translation>Eigenschaft ändern</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>one of these</source>
        <translation>eines davon</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>girth</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>playback speed</source>
        <translation>Abspieltempo</translation>
    </message>
    <message>
        <source>walking speed</source>
        <translation>Gehtempo</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>clip while at rest</source>
        <translation>Clip in Ruhe</translation>
    </message>
    <message>
        <source>place in that clip</source>
        <translation>Stelle in diesem Clip</translation>
    </message>
    <message>
        <source>whoever it came from</source>
        <translation>den, von dem es kam</translation>
    </message>
    <message>
        <source>the nearest with</source>
        <translation>den Nächsten mit</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>einen Ort</translation>
    </message>
    <message>
        <source>There is nothing to repeat: press “+ in it”.</source>
        <translation>Es gibt nichts zu wiederholen: Drücken Sie „+ darin“.</translation>
    </message>
    <message>
        <source>There is only one to choose: press “+ or…” for another.</source>
        <translation>Es gibt nur eines zur Wahl: Drücken Sie „+ oder …“ für ein weiteres.</translation>
    </message>
    <message>
        <source>None of them ever comes: let one come more often.</source>
        <translation>Keines davon kommt je: Lassen Sie eines öfter kommen.</translation>
    </message>
    <message>
        <source>A place is nobody to go after: choose whom.</source>
        <translation>Einem Ort kann man nicht nachgehen: Wählen Sie, wem.</translation>
    </message>
    <message>
        <source>Nobody has a slot of that name: choose one.</source>
        <translation>Niemand hat eine Farbfläche dieses Namens: Wählen Sie eine.</translation>
    </message>
    <message>
        <source>When the place ahead of someone gets free</source>
        <translation>Wenn der Ort vor jemandem frei wird</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>(%1)</source>
        <translation>(%1)</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>either %1</source>
        <translation>entweder %1</translation>
    </message>
    <message>
        <source>full: the place</source>
        <translation>voll: der Ort</translation>
    </message>
    <message>
        <source>happens</source>
        <translation>geschieht</translation>
    </message>
    <message>
        <source>does not happen</source>
        <translation>geschieht nicht</translation>
    </message>
    <message>
        <source>is</source>
        <translation>ist</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>ist nicht</translation>
    </message>
    <message>
        <source>number of characters in</source>
        <translation>Zahl der Figuren in</translation>
    </message>
    <message>
        <source>the selected characters</source>
        <translation>die ausgewählten Figuren</translation>
    </message>
    <message>
        <source>It does nothing yet: type the event that it waits for.</source>
        <translation>Sie tut noch nichts: das Ereignis eingeben, auf das sie wartet.</translation>
    </message>
    <message>
        <source>It does nothing yet: type the event to send.</source>
        <translation>Sie tut noch nichts: das Ereignis eingeben, das gesendet wird.</translation>
    </message>
    <message>
        <source>It does nothing yet: type the event to wait for.</source>
        <translation>Sie tut noch nichts: das Ereignis eingeben, auf das gewartet wird.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a clip.</source>
        <translation>Sie tut noch nichts: einen Clip wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a place.</source>
        <translation>Sie tut noch nichts: einen Ort wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a path.</source>
        <translation>Sie tut noch nichts: einen Weg wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a number; make one below, under “Tags and numbers”.</source>
        <translation>Sie tut noch nichts: eine Zahl wählen; unten unter „Marken und Zahlen“ eine anlegen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a template.</source>
        <translation>Sie tut noch nichts: eine Vorlage wählen.</translation>
    </message>
    <message>
        <source>It never comes: its conditions exclude each other. Remove one of them.</source>
        <translation>Sie kommt nie: Ihre Bedingungen schließen einander aus. Eine davon entfernen.</translation>
    </message>
    <message>
        <source>It never comes: “%1” above it comes at the same occasion. Let this one wait until they are free, or give one of them a condition.</source>
        <translation>Sie kommt nie: „%1“ über ihr kommt beim selben Anlass. Diese warten lassen, bis die Figuren frei sind, oder einer der beiden eine Bedingung geben.</translation>
    </message>
    <message>
        <source>It gets nothing done: “%1” breaks it off at once. Let one of them wait until they are free, or give it a condition.</source>
        <translation>Sie bringt nichts zustande: „%1“ bricht sie sofort ab. Eine der beiden warten lassen, bis die Figuren frei sind, oder ihr eine Bedingung geben.</translation>
    </message>
    <message>
        <source>It undoes what “%1” does at the same occasion. Give one of them a condition.</source>
        <translation>Sie macht zunichte, was „%1“ beim selben Anlass tut. Einer der beiden eine Bedingung geben.</translation>
    </message>
    <message>
        <source>The scene has no seats to sit on: bring a stage with seats along.</source>
        <translation>Die Szene hat keine Sitze zum Hinsetzen: eine Bühne mit Sitzen hereinholen.</translation>
    </message>
    <message>
        <source>There is no exit to leave at, so characters stay: paint one with the environment brush (I).</source>
        <translation>Es gibt keinen Ausgang, darum bleiben die Figuren: mit dem Umgebungspinsel (I) einen malen.</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>leave the scene at the nearest exit</source>
        <translation>die Szene am nächsten Ausgang verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the nearest free exit</source>
        <translation>die Szene am nächsten freien Ausgang verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the first free exit</source>
        <translation>die Szene am ersten freien Ausgang verlassen</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>tag {tag}</source>
        <translation>Marke {tag} geben</translation>
    </message>
    <message>
        <source>by</source>
        <translation>um</translation>
    </message>
    <message>
        <source>add {value} to {number}</source>
        <translation>{value} zu {number} hinzuzählen</translation>
    </message>
    <message>
        <source>appear at {place}</source>
        <translation>bei {place} erscheinen</translation>
    </message>
    <message>
        <source>for</source>
        <translation>lang</translation>
    </message>
    <message>
        <source>run {metres} m away from the nearest one tagged {tag}</source>
        <translation>{metres} m weit vom Nächsten mit der Marke {tag} weglaufen</translation>
    </message>
    <message>
        <source>run {metres} m away from {place}</source>
        <translation>{metres} m weit weglaufen: {place}</translation>
    </message>
    <message>
        <source>up to</source>
        <translation>bis auf</translation>
    </message>
    <message>
        <source>How near they come</source>
        <translation>Wie nahe sie kommen</translation>
    </message>
    <message>
        <source>until something else comes</source>
        <translation>bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>follow whoever it came from for {seconds} s</source>
        <translation>{seconds} s lang dem folgen, von dem es kam</translation>
    </message>
    <message>
        <source>follow whoever it came from until something else comes</source>
        <translation>dem folgen, von dem es kam, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>follow the nearest one tagged {tag} for {seconds} s</source>
        <translation>{seconds} s lang dem Nächsten mit der Marke {tag} folgen</translation>
    </message>
    <message>
        <source>follow the nearest one tagged {tag} until something else comes</source>
        <translation>dem Nächsten mit der Marke {tag} folgen, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>follow {place} for {seconds} s</source>
        <translation>{seconds} s lang folgen: {place}</translation>
    </message>
    <message>
        <source>follow {place} until something else comes</source>
        <translation>folgen, bis etwas anderes kommt: {place}</translation>
    </message>
    <message>
        <source>walk along {path}</source>
        <translation>{path} entlanggehen</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>however long</source>
        <translation>wie lange auch immer</translation>
    </message>
    <message>
        <source>go to whoever it came from</source>
        <translation>zu dem gehen, von dem es kam</translation>
    </message>
    <message>
        <source>go to the nearest one tagged {tag}</source>
        <translation>zum Nächsten mit der Marke {tag} gehen</translation>
    </message>
    <message>
        <source>go to {place}</source>
        <translation>zu {place} gehen</translation>
    </message>
    <message>
        <source>of any path</source>
        <translation>eines beliebigen Wegs</translation>
    </message>
    <message>
        <source>with any name</source>
        <translation>mit beliebigem Namen</translation>
    </message>
    <message>
        <source>go to the nearest place of {path}</source>
        <translation>zum nächsten Ort von {path} gehen</translation>
    </message>
    <message>
        <source>go to the nearest place named {place}</source>
        <translation>zum nächsten Ort namens {place} gehen</translation>
    </message>
    <message>
        <source>go to the nearest place</source>
        <translation>zum nächsten Ort gehen</translation>
    </message>
    <message>
        <source>go to the nearest free place of {path}</source>
        <translation>zum nächsten freien Ort von {path} gehen</translation>
    </message>
    <message>
        <source>go to the nearest free place named {place}</source>
        <translation>zum nächsten freien Ort namens {place} gehen</translation>
    </message>
    <message>
        <source>go to the nearest free place</source>
        <translation>zum nächsten freien Ort gehen</translation>
    </message>
    <message>
        <source>go to the first free place of {path}</source>
        <translation>zum ersten freien Ort von {path} gehen</translation>
    </message>
    <message>
        <source>go to the first free place named {place}</source>
        <translation>zum ersten freien Ort namens {place} gehen</translation>
    </message>
    <message>
        <source>go to the first free place</source>
        <translation>zum ersten freien Ort gehen</translation>
    </message>
    <message>
        <source>move up to the next free place of {path}</source>
        <translation>zum nächsten freien Ort von {path} aufrücken</translation>
    </message>
    <message>
        <source>move up to the next free place named {place}</source>
        <translation>zum nächsten freien Ort namens {place} aufrücken</translation>
    </message>
    <message>
        <source>move up to the next free place</source>
        <translation>zum nächsten freien Ort aufrücken</translation>
    </message>
    <message>
        <source>of all exits</source>
        <translation>von allen Ausgängen</translation>
    </message>
    <message>
        <source>leave the scene at {place}</source>
        <translation>die Szene bei {place} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the nearest place of {path}</source>
        <translation>die Szene am nächsten Ort von {path} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the nearest place named {place}</source>
        <translation>die Szene am nächsten Ort namens {place} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the nearest free place of {path}</source>
        <translation>die Szene am nächsten freien Ort von {path} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the nearest free place named {place}</source>
        <translation>die Szene am nächsten freien Ort namens {place} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the first free place of {path}</source>
        <translation>die Szene am ersten freien Ort von {path} verlassen</translation>
    </message>
    <message>
        <source>leave the scene at the first free place named {place}</source>
        <translation>die Szene am ersten freien Ort namens {place} verlassen</translation>
    </message>
    <message>
        <source>where they are</source>
        <translation>wo sie sind</translation>
    </message>
    <message>
        <source>at this place</source>
        <translation>an diesem Ort</translation>
    </message>
    <message>
        <source>at the nearest</source>
        <translation>am nächsten</translation>
    </message>
    <message>
        <source>at the nearest free one</source>
        <translation>am nächsten freien</translation>
    </message>
    <message>
        <source>at the first free one</source>
        <translation>am ersten freien</translation>
    </message>
    <message>
        <source>look at whoever it came from for {seconds} s</source>
        <translation>{seconds} s lang den ansehen, von dem es kam</translation>
    </message>
    <message>
        <source>look at whoever it came from until something else comes</source>
        <translation>den ansehen, von dem es kam, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>look at the nearest one tagged {tag} for {seconds} s</source>
        <translation>{seconds} s lang den Nächsten mit der Marke {tag} ansehen</translation>
    </message>
    <message>
        <source>look at the nearest one tagged {tag} until something else comes</source>
        <translation>den Nächsten mit der Marke {tag} ansehen, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>look at {place} for {seconds} s</source>
        <translation>{seconds} s lang ansehen: {place}</translation>
    </message>
    <message>
        <source>look at {place} until something else comes</source>
        <translation>ansehen, bis etwas anderes kommt: {place}</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>wie oft</translation>
    </message>
    <message>
        <source>{inside}</source>
        <translation>{inside}</translation>
    </message>
    <message>
        <source>play {clips}</source>
        <translation>{clips} spielen</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>untag {tag}</source>
        <translation>Marke {tag} nehmen</translation>
    </message>
    <message>
        <source>for ever</source>
        <translation>für immer</translation>
    </message>
    <message>
        <source>repeat for ever {inside}</source>
        <translation>für immer wiederholen {inside}</translation>
    </message>
    <message>
        <source>repeat {times} × {inside}</source>
        <translation>{times} × wiederholen {inside}</translation>
    </message>
    <message>
        <source>within</source>
        <translation>im Umkreis</translation>
    </message>
    <message>
        <source>Whoever is nearer hears it</source>
        <translation>Wer näher ist, hört es</translation>
    </message>
    <message>
        <source>runs at</source>
        <translation>läuft mit</translation>
    </message>
    <message>
        <source>How long it takes from one to the next</source>
        <translation>Wie lange es von einer Figur zur nächsten braucht</translation>
    </message>
    <message>
        <source> s/m</source>
        <translation> s/m</translation>
    </message>
    <message>
        <source>once for all</source>
        <translation>für alle zugleich</translation>
    </message>
    <message>
        <source>Rules that hear it can ask for it, or walk as fast</source>
        <translation>Regeln, die es hören, können danach fragen oder so schnell gehen lassen</translation>
    </message>
    <message>
        <source>send “{event}” to themselves</source>
        <translation>„{event}“ an sich selbst senden</translation>
    </message>
    <message>
        <source>send “{event}” to those within {metres} m</source>
        <translation>„{event}“ an alle im Umkreis von {metres} m senden</translation>
    </message>
    <message>
        <source>send “{event}” to those tagged {tag}</source>
        <translation>„{event}“ an alle mit Marke {tag} senden</translation>
    </message>
    <message>
        <source>send “{event}” to their group</source>
        <translation>„{event}“ an ihre Gruppe senden</translation>
    </message>
    <message>
        <source>send “{event}” to everybody</source>
        <translation>„{event}“ an alle senden</translation>
    </message>
    <message>
        <source>to</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>set {number} to {value}</source>
        <translation>{number} auf {value} setzen</translation>
    </message>
    <message>
        <source>turn {color}</source>
        <translation>{color} färben</translation>
    </message>
    <message>
        <source>turn {color} at {slot}</source>
        <translation>bei {slot} {color} färben</translation>
    </message>
    <message>
        <source>become {value} × as tall</source>
        <translation>{value} × so groß werden</translation>
    </message>
    <message>
        <source>move {value} × as fast</source>
        <translation>sich {value} × so schnell bewegen</translation>
    </message>
    <message>
        <source>from now on {clips}</source>
        <translation>von nun an {clips}</translation>
    </message>
    <message>
        <source>go to {value} of their clip</source>
        <translation>zu {value} des Clips springen</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>at {value} m/s</source>
        <translation>mit {value} m/s</translation>
    </message>
    <message>
        <source>however far</source>
        <translation>wie weit auch immer</translation>
    </message>
    <message>
        <source>sit on the nearest free seat within {metres} m</source>
        <translation>auf den nächsten freien Sitz binnen {metres} m setzen</translation>
    </message>
    <message>
        <source>turn to whoever it came from</source>
        <translation>sich zu dem drehen, von dem es kam</translation>
    </message>
    <message>
        <source>turn to the nearest one tagged {tag}</source>
        <translation>sich zum Nächsten mit der Marke {tag} drehen</translation>
    </message>
    <message>
        <source>turn to {place}</source>
        <translation>zu {place} drehen</translation>
    </message>
    <message>
        <source>about</source>
        <translation>etwa</translation>
    </message>
    <message>
        <source>wait about {seconds} s</source>
        <translation>etwa {seconds} s warten</translation>
    </message>
    <message>
        <source>wait for “{event}”, at most {seconds} s</source>
        <translation>auf „{event}“ warten, höchstens {seconds} s</translation>
    </message>
    <message>
        <source>wait for “{event}”</source>
        <translation>auf „{event}“ warten</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source> % of cases</source>
        <translation> % der Fälle</translation>
    </message>
    <message>
        <source>by chance in {chance} % of cases</source>
        <translation>zufällig in {chance} % der Fälle</translation>
    </message>
    <message>
        <source>except by chance in {chance} % of cases</source>
        <translation>außer zufällig in {chance} % der Fälle</translation>
    </message>
    <message>
        <source>walking {path}</source>
        <translation>auf {path}</translation>
    </message>
    <message>
        <source>not walking {path}</source>
        <translation>nicht auf {path}</translation>
    </message>
    <message>
        <source>tagged {tag}</source>
        <translation>mit Marke {tag}</translation>
    </message>
    <message>
        <source>not tagged {tag}</source>
        <translation>nicht mit Marke {tag}</translation>
    </message>
    <message>
        <source>in {place}</source>
        <translation>in {place}</translation>
    </message>
    <message>
        <source>not in {place}</source>
        <translation>nicht in {place}</translation>
    </message>
    <message>
        <source>{place} full</source>
        <translation>{place} voll</translation>
    </message>
    <message>
        <source>{place} not full</source>
        <translation>{place} nicht voll</translation>
    </message>
    <message>
        <source>not seated</source>
        <translation>nicht sitzend</translation>
    </message>
    <message>
        <source>{number} below {value}</source>
        <translation>{number} unter {value}</translation>
    </message>
    <message>
        <source>{number} not below {value}</source>
        <translation>{number} nicht unter {value}</translation>
    </message>
    <message>
        <source>{number} at {value}</source>
        <translation>{number} gleich {value}</translation>
    </message>
    <message>
        <source>{number} not at {value}</source>
        <translation>{number} nicht gleich {value}</translation>
    </message>
    <message>
        <source>{number} above {value}</source>
        <translation>{number} über {value}</translation>
    </message>
    <message>
        <source>{number} not above {value}</source>
        <translation>{number} nicht über {value}</translation>
    </message>
    <message>
        <source>a {template}</source>
        <translation>{template}</translation>
    </message>
    <message>
        <source>not a {template}</source>
        <translation>nicht {template}</translation>
    </message>
    <message>
        <source>the event’s number below {value}</source>
        <translation>die Zahl des Ereignisses unter {value}</translation>
    </message>
    <message>
        <source>the event’s number not below {value}</source>
        <translation>die Zahl des Ereignisses nicht unter {value}</translation>
    </message>
    <message>
        <source>the event’s number at {value}</source>
        <translation>die Zahl des Ereignisses gleich {value}</translation>
    </message>
    <message>
        <source>the event’s number not at {value}</source>
        <translation>die Zahl des Ereignisses nicht gleich {value}</translation>
    </message>
    <message>
        <source>the event’s number above {value}</source>
        <translation>die Zahl des Ereignisses über {value}</translation>
    </message>
    <message>
        <source>the event’s number not above {value}</source>
        <translation>die Zahl des Ereignisses nicht über {value}</translation>
    </message>
    <message>
        <source>characters in {place} below {value}</source>
        <translation>Figuren in {place} unter {value}</translation>
    </message>
    <message>
        <source>characters in {place} not below {value}</source>
        <translation>Figuren in {place} nicht unter {value}</translation>
    </message>
    <message>
        <source>characters in {place} at {value}</source>
        <translation>Figuren in {place} gleich {value}</translation>
    </message>
    <message>
        <source>characters in {place} not at {value}</source>
        <translation>Figuren in {place} nicht gleich {value}</translation>
    </message>
    <message>
        <source>characters in {place} above {value}</source>
        <translation>Figuren in {place} über {value}</translation>
    </message>
    <message>
        <source>characters in {place} not above {value}</source>
        <translation>Figuren in {place} nicht über {value}</translation>
    </message>
    <message>
        <source>showing {clip}</source>
        <translation>mit Clip {clip}</translation>
    </message>
    <message>
        <source>not showing {clip}</source>
        <translation>nicht mit Clip {clip}</translation>
    </message>
    <message>
        <source>{property} below {value}</source>
        <translation>{property} unter {value}</translation>
    </message>
    <message>
        <source>{property} not below {value}</source>
        <translation>{property} nicht unter {value}</translation>
    </message>
    <message>
        <source>{property} at {value}</source>
        <translation>{property} gleich {value}</translation>
    </message>
    <message>
        <source>{property} not at {value}</source>
        <translation>{property} nicht gleich {value}</translation>
    </message>
    <message>
        <source>{property} above {value}</source>
        <translation>{property} über {value}</translation>
    </message>
    <message>
        <source>{property} not above {value}</source>
        <translation>{property} nicht über {value}</translation>
    </message>
    <message>
        <source>speed below {value}</source>
        <translation>Tempo unter {value}</translation>
    </message>
    <message>
        <source>speed not below {value}</source>
        <translation>Tempo nicht unter {value}</translation>
    </message>
    <message>
        <source>speed at {value}</source>
        <translation>Tempo gleich {value}</translation>
    </message>
    <message>
        <source>speed not at {value}</source>
        <translation>Tempo nicht gleich {value}</translation>
    </message>
    <message>
        <source>speed above {value}</source>
        <translation>Tempo über {value}</translation>
    </message>
    <message>
        <source>speed not above {value}</source>
        <translation>Tempo nicht über {value}</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>When the place ahead of someone in {path} gets free</source>
        <translation>Wenn der Ort vor jemandem in {path} frei wird</translation>
    </message>
    <message>
        <source>When someone arrives at {place}</source>
        <translation>Wenn jemand ankommt: {place}</translation>
    </message>
    <message>
        <source>When someone enters {place}</source>
        <translation>Wenn jemand betritt: {place}</translation>
    </message>
    <message>
        <source>When “{event}” reaches someone</source>
        <translation>Wenn „{event}“ jemanden erreicht</translation>
    </message>
    <message>
        <source>Every {seconds} s</source>
        <translation>Alle {seconds} s</translation>
    </message>
    <message>
        <source>When someone leaves {place}</source>
        <translation>Wenn jemand verlässt: {place}</translation>
    </message>
    <message>
        <source>When someone reaches the end of {path}</source>
        <translation>Wenn jemand das Ende erreicht: {path}</translation>
    </message>
    <message>
        <source>When someone gets faster than {metresPerSecond} m/s</source>
        <translation>Wenn jemand schneller wird als {metresPerSecond} m/s</translation>
    </message>
    <message>
        <source>When someone gets slower than {metresPerSecond} m/s</source>
        <translation>Wenn jemand langsamer wird als {metresPerSecond} m/s</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>langsamer als</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>schneller als</translation>
    </message>
    <message>
        <source>When someone tagged {tag} comes within {metres} m</source>
        <translation>Wenn jemand mit Marke {tag} näher als {metres} m kommt</translation>
    </message>
    <message>
        <source>When someone has stood for {seconds} s</source>
        <translation>Wenn jemand {seconds} s gestanden hat</translation>
    </message>
    <message>
        <source>event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>play {clips} until something else comes</source>
        <translation>{clips} spielen, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>yields to others further up</source>
        <translation>weicht anderen Regeln weiter oben</translation>
    </message>
    <message>
        <source>take on a state</source>
        <translation>einen Zustand annehmen</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>beginning within</source>
        <translation>Beginn innerhalb von</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>take on “{state}”</source>
        <translation>„{state}“ annehmen</translation>
    </message>
    <message>
        <source>take on “{state}” within {within} s</source>
        <translation>„{state}“ innerhalb von {within} s annehmen</translation>
    </message>
    <message>
        <source>take on “{state}” over {seconds} s</source>
        <translation>„{state}“ über {seconds} s annehmen</translation>
    </message>
    <message>
        <source>a state is recalled</source>
        <translation>ein Zustand wird abgerufen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>irgendeiner</translation>
    </message>
    <message>
        <source>When someone takes on a state</source>
        <translation>Wenn jemand einen Zustand annimmt</translation>
    </message>
    <message>
        <source>When someone takes on “{state}”</source>
        <translation>Wenn jemand „{state}“ annimmt</translation>
    </message>
    <message>
        <source>The state is not there any more: choose another one.</source>
        <translation>Den Zustand gibt es nicht mehr: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a state; the panel States keeps one.</source>
        <translation>Sie tut noch nichts: Wählen Sie einen Zustand; das Bedienfeld „Zustände“ merkt einen.</translation>
    </message>
    <message>
        <source>take on a feature</source>
        <translation>ein Merkmal annehmen</translation>
    </message>
    <message>
        <source>become “{feature}”</source>
        <translation>wird „{feature}“</translation>
    </message>
    <message>
        <source>of a feature</source>
        <translation>mit einem Merkmal</translation>
    </message>
    <message>
        <source>“{feature}”</source>
        <translation>„{feature}“</translation>
    </message>
    <message>
        <source>not “{feature}”</source>
        <translation>nicht „{feature}“</translation>
    </message>
    <message>
        <source>a feature changes</source>
        <translation>ein Merkmal ändert sich</translation>
    </message>
    <message>
        <source>When a feature of someone changes</source>
        <translation>Wenn sich ein Merkmal von jemandem ändert</translation>
    </message>
    <message>
        <source>When someone becomes “{feature}”</source>
        <translation>Wenn jemand „{feature}“ wird</translation>
    </message>
    <message>
        <source>The feature is not there any more: choose another one.</source>
        <translation>Das Merkmal ist nicht mehr da: ein anderes wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a feature.</source>
        <translation>Sie tut noch nichts: ein Merkmal wählen.</translation>
    </message>
    <message>
        <source>run {metres} m away from the nearest of their {relation}</source>
        <translation>{metres} m weit vom Nächsten aus „{relation}“ weglaufen</translation>
    </message>
    <message>
        <source>follow the nearest of their {relation} for {seconds} s</source>
        <translation>{seconds} s lang dem Nächsten aus „{relation}“ folgen</translation>
    </message>
    <message>
        <source>follow the nearest of their {relation} until something else comes</source>
        <translation>dem Nächsten aus „{relation}“ folgen, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>go to the nearest of their {relation}</source>
        <translation>zum Nächsten aus „{relation}“ gehen</translation>
    </message>
    <message>
        <source>look at the nearest of their {relation} for {seconds} s</source>
        <translation>{seconds} s lang den Nächsten aus „{relation}“ ansehen</translation>
    </message>
    <message>
        <source>look at the nearest of their {relation} until something else comes</source>
        <translation>den Nächsten aus „{relation}“ ansehen, bis etwas anderes kommt</translation>
    </message>
    <message>
        <source>send “{event}” to their {relation}</source>
        <translation>„{event}“ an die aus „{relation}“ senden</translation>
    </message>
    <message>
        <source>turn to the nearest of their {relation}</source>
        <translation>sich zum Nächsten aus „{relation}“ drehen</translation>
    </message>
    <message>
        <source>number of those related</source>
        <translation>Zahl der Verbundenen</translation>
    </message>
    <message>
        <source>the number of their {relation} below {value}</source>
        <translation>die Zahl derer aus „{relation}“ unter {value}</translation>
    </message>
    <message>
        <source>the number of their {relation} not below {value}</source>
        <translation>die Zahl derer aus „{relation}“ nicht unter {value}</translation>
    </message>
    <message>
        <source>the number of their {relation} at {value}</source>
        <translation>die Zahl derer aus „{relation}“ gleich {value}</translation>
    </message>
    <message>
        <source>the number of their {relation} not at {value}</source>
        <translation>die Zahl derer aus „{relation}“ nicht gleich {value}</translation>
    </message>
    <message>
        <source>the number of their {relation} above {value}</source>
        <translation>die Zahl derer aus „{relation}“ über {value}</translation>
    </message>
    <message>
        <source>the number of their {relation} not above {value}</source>
        <translation>die Zahl derer aus „{relation}“ nicht über {value}</translation>
    </message>
    <message>
        <source>arrives at</source>
        <translation>kommt an bei</translation>
    </message>
    <message>
        <source>leaves</source>
        <translation>verlässt</translation>
    </message>
    <message>
        <source>hears</source>
        <translation>hört</translation>
    </message>
    <message>
        <source>one related does something</source>
        <translation>ein Verbundener tut etwas</translation>
    </message>
    <message>
        <source>When one of someone’s {relation} arrives at {place}</source>
        <translation>Wenn jemand aus „{relation}“ ankommt: {place}</translation>
    </message>
    <message>
        <source>When one of someone’s {relation} leaves {place}</source>
        <translation>Wenn jemand aus „{relation}“ weggeht: {place}</translation>
    </message>
    <message>
        <source>When one of someone’s {relation} hears “{event}”</source>
        <translation>Wenn jemand aus „{relation}“ hört: „{event}“</translation>
    </message>
    <message>
        <source>The relation is not there any more: choose another one.</source>
        <translation>Die Beziehung gibt es nicht mehr: eine andere wählen.</translation>
    </message>
    <message>
        <source>all of their</source>
        <translation>alle aus</translation>
    </message>
    <message>
        <source>relations of any kind</source>
        <translation>Beziehungen jeder Art</translation>
    </message>
    <message>
        <source>the nearest of their</source>
        <translation>der Nächste aus</translation>
    </message>
    <message>
        <source>switch on</source>
        <translation>einschalten</translation>
    </message>
    <message>
        <source>switch off</source>
        <translation>ausschalten</translation>
    </message>
    <message>
        <source>flash</source>
        <translation>blitzen</translation>
    </message>
    <message>
        <source>sweep from side to side</source>
        <translation>hin und her schwenken</translation>
    </message>
    <message>
        <source>tell a light</source>
        <translation>einem Licht sagen</translation>
    </message>
    <message>
        <source>switch the light “{light}” on</source>
        <translation>das Licht „{light}“ einschalten</translation>
    </message>
    <message>
        <source>switch the light “{light}” on over {seconds} s</source>
        <translation>das Licht „{light}“ in {seconds} s aufblenden</translation>
    </message>
    <message>
        <source>switch the light “{light}” off</source>
        <translation>das Licht „{light}“ ausschalten</translation>
    </message>
    <message>
        <source>switch the light “{light}” off over {seconds} s</source>
        <translation>das Licht „{light}“ in {seconds} s abblenden</translation>
    </message>
    <message>
        <source>let the light “{light}” flash for {seconds} s</source>
        <translation>das Licht „{light}“ {seconds} s lang blitzen lassen</translation>
    </message>
    <message>
        <source>let the light “{light}” sweep for {seconds} s</source>
        <translation>das Licht „{light}“ {seconds} s lang schwenken lassen</translation>
    </message>
    <message>
        <source>The light is not there any more: choose another one.</source>
        <translation>Das Licht gibt es nicht mehr: ein anderes wählen.</translation>
    </message>
    <message>
        <source>It does nothing yet: choose a light; the panel Light adds one.</source>
        <translation>Sie tut noch nichts: ein Licht wählen; das Bedienfeld „Licht“ fügt eines hinzu.</translation>
    </message>
    <message>
        <source>a new tag, %1</source>
        <translation>eine neue Marke, %1</translation>
    </message>
    <message>
        <source>It is about whoever it came from, but it comes from nobody: let it begin with an event or with someone near, or choose whom it is about.</source>
        <translation>Sie handelt von dem, von dem es kam, aber es kommt von niemandem: Lassen Sie sie mit einem Ereignis beginnen oder damit, dass jemand nahe ist, oder wählen Sie, von wem sie handelt.</translation>
    </message>
    <message>
        <source>It asks for an event’s number, but comes without one: let it begin with an event, or give the number.</source>
        <translation>Sie fragt nach der Zahl eines Ereignisses, kommt aber ohne eines: Lassen Sie sie mit einem Ereignis beginnen, oder geben Sie die Zahl an.</translation>
    </message>
    <message>
        <source>What stands below “do it again” is never done: move it up, or remove it.</source>
        <translation>Was unter „von vorn“ steht, geschieht nie: Schieben Sie es nach oben, oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>schwarz</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>braun</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>gelb</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grün</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>türkis</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>violett</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rosa</translation>
    </message>
    <message>
        <source>no. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>run {metres} m away from whoever it came from, or anywhere</source>
        <translation>{metres} m weit von dem weglaufen, von dem es kam, oder irgendwohin</translation>
    </message>
    <message>
        <source>with the number</source>
        <translation>mit der Zahl</translation>
    </message>
    <message>
        <source>walks along a path</source>
        <translation>geht auf einem Weg</translation>
    </message>
    <message>
        <source>has a choice of a feature</source>
        <translation>hat ein bestimmtes Merkmal</translation>
    </message>
    <message>
        <source>has a tag</source>
        <translation>hat eine Marke</translation>
    </message>
    <message>
        <source>is inside a place</source>
        <translation>ist an einem Ort</translation>
    </message>
    <message>
        <source>a place is full</source>
        <translation>ein Ort ist voll</translation>
    </message>
    <message>
        <source>is seated</source>
        <translation>sitzt</translation>
    </message>
    <message>
        <source>their own number is…</source>
        <translation>die eigene Zahl ist …</translation>
    </message>
    <message>
        <source>is of a template</source>
        <translation>ist von einer Vorlage</translation>
    </message>
    <message>
        <source>the event’s number is…</source>
        <translation>die Zahl des Ereignisses ist …</translation>
    </message>
    <message>
        <source>the number of characters in a place is…</source>
        <translation>die Zahl der Figuren an einem Ort ist …</translation>
    </message>
    <message>
        <source>one of their properties is…</source>
        <translation>eine Eigenschaft ist …</translation>
    </message>
    <message>
        <source>the number of those related is…</source>
        <translation>die Zahl der Verbundenen ist …</translation>
    </message>
    <message>
        <source>their speed is…</source>
        <translation>die Geschwindigkeit ist …</translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>Add template</source>
        <translation>Vorlage hinzufügen</translation>
    </message>
    <message>
        <source>Change template</source>
        <translation>Vorlage wechseln</translation>
    </message>
    <message>
        <source>Remove template</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Add stage</source>
        <translation>Bühne hinzufügen</translation>
    </message>
    <message>
        <source>Change stage</source>
        <translation>Bühne ändern</translation>
    </message>
    <message>
        <source>Remove stage</source>
        <translation>Bühne entfernen</translation>
    </message>
    <message>
        <source>Set camera</source>
        <translation>Kamera setzen</translation>
    </message>
    <message>
        <source>Remove camera</source>
        <translation>Kamera entfernen</translation>
    </message>
    <message>
        <source>Set cameras</source>
        <translation>Kameras setzen</translation>
    </message>
    <message>
        <source>Set lighting</source>
        <translation>Licht setzen</translation>
    </message>
    <message>
        <source>Set environment</source>
        <translation>Umgebung setzen</translation>
    </message>
    <message>
        <source>Keep the pose</source>
        <translation>Haltung behalten</translation>
    </message>
    <message>
        <source>Create characters</source>
        <translation>Figuren erschaffen</translation>
    </message>
    <message>
        <source>Remove characters</source>
        <translation>Figuren entfernen</translation>
    </message>
    <message>
        <source>Change characters</source>
        <translation>Figuren ändern</translation>
    </message>
    <message>
        <source>Put characters on the ground</source>
        <translation>Figuren auf den Boden stellen</translation>
    </message>
    <message>
        <source>Keep a state</source>
        <translation>Einen Zustand merken</translation>
    </message>
    <message>
        <source>Recall a state</source>
        <translation>Einen Zustand abrufen</translation>
    </message>
    <message>
        <source>Remove a state</source>
        <translation>Einen Zustand entfernen</translation>
    </message>
    <message>
        <source>Rename a state</source>
        <translation>Einen Zustand umbenennen</translation>
    </message>
    <message>
        <source>Arrange states</source>
        <translation>Zustände ordnen</translation>
    </message>
    <message>
        <source>Change states</source>
        <translation>Zustände ändern</translation>
    </message>
    <message>
        <source>Set a feature</source>
        <translation>Merkmal setzen</translation>
    </message>
    <message>
        <source>Relate characters</source>
        <translation>Figuren verbinden</translation>
    </message>
    <message>
        <source>Take relations away</source>
        <translation>Beziehungen lösen</translation>
    </message>
    <message>
        <source>Duplicate characters</source>
        <translation>Figuren duplizieren</translation>
    </message>
    <message>
        <source>Add rules</source>
        <translation>Regeln hinzufügen</translation>
    </message>
</context>
<context>
    <name>SelectTool</name>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>Click: select · Drag: area, or move who is selected · Shift: add to the selection · Ctrl: in or out of it · Double click: puts a place into a path, a corner into a line or takes it out · L: lasso or rectangle · Delete: remove · F: show the selection</source>
        <translation>Klick: auswählen · Ziehen: Bereich, oder die Auswahl verschieben · Umschalt: zur Auswahl dazu · Strg: hinein oder heraus · Doppelklick: setzt einen Ort in einen Weg, eine Ecke in eine Linie oder nimmt sie heraus · L: Lasso oder Rechteck · Entf: löschen · F: Auswahl zeigen</translation>
    </message>
</context>
<context>
    <name>SelectionCommands</name>
    <message>
        <source>Nobody is selected: there is nobody to delete.</source>
        <translation>Niemand ist ausgewählt: Es gibt niemanden zu löschen.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n place(s)</source>
        <translation>
            <numerusform>Einen Ort löschen</numerusform>
            <numerusform>%n Orte löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n character(s)</source>
        <translation>
            <numerusform>%n Figur löschen</numerusform>
            <numerusform>%n Figuren löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Put %n character(s) on the ground</source>
        <translation>
            <numerusform>%n Figur auf den Boden stellen</numerusform>
            <numerusform>%n Figuren auf den Boden stellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters put on the ground</source>
        <translation>
            <numerusform>%n Figur auf den Boden gestellt</numerusform>
            <numerusform>%n Figuren auf den Boden gestellt</numerusform>
        </translation>
    </message>
    <message>
        <source>All of them stand where characters can walk.</source>
        <translation>Alle stehen, wo Figuren gehen können.</translation>
    </message>
</context>
<context>
    <name>ShapeDrag</name>
    <message>
        <source>Add a corner</source>
        <translation>Eine Ecke setzen</translation>
    </message>
    <message>
        <source>Nothing to stand on there: the pointer is on the sky, or on something upright. Click on the ground beside it.</source>
        <translation>Dort ist nichts, worauf man stehen kann: Der Zeiger ist am Himmel oder an etwas Aufrechtem. Klicken Sie daneben auf den Boden.</translation>
    </message>
    <message>
        <source>Draw corners</source>
        <translation>Ecken zeichnen</translation>
    </message>
    <message>
        <source>That is too far away or has more than %1 corners: press Enter, and begin another one.</source>
        <translation>Das ist zu weit weg oder hat mehr als %1 Ecken: Drücken Sie die Eingabetaste und beginnen Sie eine neue.</translation>
    </message>
    <message>
        <source>Close a line</source>
        <translation>Eine Linie schließen</translation>
    </message>
    <message>
        <source>Close it</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>ShownTake</name>
    <message>
        <source>The take &quot;%1&quot; is shown, and people move as they did in it. To tell them something, take it from here (menu Play), or show the scene as it plays (panel Takes).</source>
        <translation>Der Take „%1“ wird gezeigt, und alle bewegen sich wie in ihm. Um ihnen etwas zu sagen, spielen Sie ab hier weiter (Menü Abspielen), oder zeigen Sie die Szene, wie sie spielt (Bedienfeld Takes).</translation>
    </message>
</context>
<context>
    <name>StateCommands</name>
    <message>
        <source>“%1”: all of them are like that already</source>
        <translation>„%1“: Alle sind schon so</translation>
    </message>
    <message numerus="yes">
        <source>“%1” recalled: %n characters changed</source>
        <translation>
            <numerusform>„%1“ abgerufen: %n Figur geändert</numerusform>
            <numerusform>„%1“ abgerufen: %n Figuren geändert</numerusform>
        </translation>
    </message>
    <message>
        <source>State %1</source>
        <translation>Zustand %1</translation>
    </message>
    <message>
        <source>Tick what the state is to hold first.</source>
        <translation>Haken Sie zuerst an, was der Zustand enthalten soll.</translation>
    </message>
    <message>
        <source>Nobody is selected whose state could be kept.</source>
        <translation>Niemand ist ausgewählt, dessen Zustand gemerkt werden könnte.</translation>
    </message>
    <message>
        <source>Nobody is there yet whose state could be kept.</source>
        <translation>Es ist noch niemand da, dessen Zustand gemerkt werden könnte.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” keeps how %n characters are now</source>
        <translation>
            <numerusform>„%1“ merkt sich, wie %n Figur jetzt ist</numerusform>
            <numerusform>„%1“ merkt sich, wie %n Figuren jetzt sind</numerusform>
        </translation>
    </message>
    <message>
        <source>Recall “%1”</source>
        <translation>„%1“ abrufen</translation>
    </message>
    <message>
        <source>Remove a state</source>
        <translation>Einen Zustand entfernen</translation>
    </message>
    <message>
        <source>A state needs a name.</source>
        <translation>Ein Zustand braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a state “%1” already.</source>
        <translation>Es gibt schon einen Zustand „%1“.</translation>
    </message>
    <message>
        <source>Rename a state</source>
        <translation>Einen Zustand umbenennen</translation>
    </message>
    <message>
        <source>Move a state</source>
        <translation>Einen Zustand verschieben</translation>
    </message>
    <message>
        <source>“%1”: none of its characters is there</source>
        <translation>„%1“: Keine seiner Figuren ist da</translation>
    </message>
    <message numerus="yes">
        <source>“%1” for %n characters, in this run alone: Stop gives the scene back</source>
        <translation>
            <numerusform>„%1“ für %n Figur, nur in diesem Lauf: Anhalten gibt die Szene zurück</numerusform>
            <numerusform>„%1“ für %n Figuren, nur in diesem Lauf: Anhalten gibt die Szene zurück</numerusform>
        </translation>
    </message>
    <message>
        <source>Wait until it is known where characters can walk, then recall the state.</source>
        <translation>Warten Sie, bis bekannt ist, wo Figuren gehen können, und rufen Sie den Zustand dann ab.</translation>
    </message>
    <message>
        <source>Nobody is in the group whose state could be kept.</source>
        <translation>In der Gruppe ist niemand, dessen Zustand gemerkt werden könnte.</translation>
    </message>
    <message>
        <source>A state holds at least one of them.</source>
        <translation>Ein Zustand enthält mindestens eines davon.</translation>
    </message>
    <message>
        <source>Change what a state holds</source>
        <translation>Ändern, was ein Zustand enthält</translation>
    </message>
    <message>
        <source>Keep “%1”</source>
        <translation>„%1“ merken</translation>
    </message>
    <message>
        <source>Keep “%1” anew</source>
        <translation>„%1“ neu merken</translation>
    </message>
    <message>
        <source>“%1”: none of its characters is selected</source>
        <translation>„%1“: keine seiner Figuren ist ausgewählt</translation>
    </message>
    <message>
        <source>Nobody is selected for whom “%1” could be recalled.</source>
        <translation>Niemand ist ausgewählt, für den „%1“ abgerufen werden könnte.</translation>
    </message>
    <message>
        <source>“%1” recalled in the run; the scene itself was like that already</source>
        <translation>„%1“ im Lauf abgerufen; die Szene selbst war schon so</translation>
    </message>
</context>
<context>
    <name>StatureNote</name>
    <message>
        <source>%1 m tall</source>
        <translation>%1 m groß</translation>
    </message>
    <message>
        <source>%1 to %2 m tall</source>
        <translation>%1 bis %2 m groß</translation>
    </message>
    <message>
        <source>%1 from %2 m
%3 to %4 m</source>
        <translation>%1 ab %2 m
%3 bis %4 m</translation>
    </message>
</context>
<context>
    <name>StepMenu</name>
    <message>
        <source>Change the length of a step</source>
        <translation>Länge eines Schritts ändern</translation>
    </message>
    <message>
        <source>Steps of 1/%1 s from the next Play on.</source>
        <translation>Schritte von 1/%1 s ab dem nächsten Abspielen.</translation>
    </message>
    <message>
        <source>1/%1 s, as Usual</source>
        <translation>1/%1 s, wie üblich</translation>
    </message>
    <message>
        <source>1/%1 s, Finer</source>
        <translation>1/%1 s, feiner</translation>
    </message>
</context>
<context>
    <name>TakeCommands</name>
    <message>
        <source>Another take is still being kept.</source>
        <translation>Ein anderer Take wird noch behalten.</translation>
    </message>
    <message>
        <source>Nothing has been played yet: press Play first.</source>
        <translation>Es wurde noch nichts gespielt: Drücken Sie zuerst Abspielen.</translation>
    </message>
    <message>
        <source>Keep what was played as a take and show it: then the selected characters can be taken again.</source>
        <translation>Behalten Sie das Gespielte als Take und zeigen Sie ihn: Dann können die gewählten Figuren neu spielen.</translation>
    </message>
    <message>
        <source>Select those who are to be taken again.</source>
        <translation>Wählen Sie aus, wer neu spielen soll.</translation>
    </message>
    <message>
        <source>The scene as it plays. Press Play to run it.</source>
        <translation>Die Szene, wie sie spielt. Abspielen lässt sie laufen.</translation>
    </message>
    <message>
        <source>The take &quot;%1&quot; is shown.</source>
        <translation>Der Take „%1“ wird gezeigt.</translation>
    </message>
    <message>
        <source>There are no takes yet: play, then keep what was played.</source>
        <translation>Es gibt noch keine Takes: Spielen Sie ab und behalten Sie dann das Gespielte.</translation>
    </message>
    <message>
        <source>Nobody walks or follows rules here: there is nothing to keep yet.</source>
        <translation>Hier geht niemand und niemand folgt Regeln: es gibt noch nichts zu behalten.</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Markers</source>
        <translation>Merkpunkte</translation>
    </message>
    <message>
        <source>Add a Marker Here</source>
        <translation>Hier einen Merkpunkt setzen</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Stichwörter</translation>
    </message>
    <message>
        <source>Call a Cue Here</source>
        <translation>Hier ein Stichwort geben</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>Recall a State Here</source>
        <translation>Hier einen Zustand abrufen</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Send an Event Here</source>
        <translation>Hier ein Ereignis senden</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>Select characters: when which rules fired for them</source>
        <translation>Figuren auswählen: wann ihre Regeln auslösten</translation>
    </message>
    <message>
        <source>Double click in a lane: what is to happen then. Or record: cues that are pressed, states that are recalled and events that are painted while it plays come here.</source>
        <translation>Doppelklick in eine Spur: was dann geschehen soll. Oder nehmen Sie auf: Stichwörter, die gedrückt, Zustände, die abgerufen, und Ereignisse, die beim Abspielen gemalt werden, kommen hierher.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Look from Here On as Now</source>
        <translation>Ab hier so blicken wie jetzt</translation>
    </message>
</context>
<context>
    <name>TimelineCommands</name>
    <message>
        <source>The scene has no cues yet: the panel Rules makes them.</source>
        <translation>Die Szene hat noch keine Stichwörter: das Bedienfeld Regeln macht sie.</translation>
    </message>
    <message>
        <source>The scene has no states yet: the panel States keeps them.</source>
        <translation>Die Szene hat noch keine Zustände: das Bedienfeld Zustände hält sie fest.</translation>
    </message>
    <message>
        <source>A timeline has at most %1 marks: remove some first.</source>
        <translation>Eine Zeitleiste hat höchstens %1 Zeitmarken: entfernen Sie erst welche.</translation>
    </message>
    <message>
        <source>Add a mark</source>
        <translation>Zeitmarke setzen</translation>
    </message>
    <message>
        <source>Marked at %1 s</source>
        <translation>Gemerkt bei %1 s</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>Zeitmarken entfernen</translation>
    </message>
    <message>
        <source>Move marks</source>
        <translation>Zeitmarken verschieben</translation>
    </message>
    <message>
        <source>Copy marks</source>
        <translation>Zeitmarken kopieren</translation>
    </message>
    <message>
        <source>There is no mark after this moment.</source>
        <translation>Nach diesem Augenblick kommt keine Zeitmarke.</translation>
    </message>
    <message>
        <source>There is no mark before this moment.</source>
        <translation>Vor diesem Augenblick liegt keine Zeitmarke.</translation>
    </message>
    <message>
        <source>It has been played up to %1 s: play on to see more.</source>
        <translation>Gespielt ist es bis %1 s: spielen Sie weiter, um mehr zu sehen.</translation>
    </message>
    <message>
        <source>missing state</source>
        <translation>Zustand fehlt</translation>
    </message>
    <message>
        <source>missing cue</source>
        <translation>Stichwort fehlt</translation>
    </message>
    <message>
        <source>Change the play range</source>
        <translation>Abspielbereich ändern</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Im Kreis</translation>
    </message>
    <message>
        <source>Around, from %1</source>
        <translation>Im Kreis, ab %1</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>%1 entlang</translation>
    </message>
    <message>
        <source>missing path</source>
        <translation>fehlender Weg</translation>
    </message>
    <message>
        <source>From %1 s on the camera looks as now: “%2”</source>
        <translation>Ab %1 s blickt die Kamera wie jetzt: „%2“</translation>
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
        <translation>Erschaffen</translation>
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
    <message>
        <source>Path Brush</source>
        <translation>Wegpinsel</translation>
    </message>
    <message>
        <source>Walk Brush</source>
        <translation>Gehpinsel</translation>
    </message>
    <message>
        <source>Environment Brush</source>
        <translation>Umgebungspinsel</translation>
    </message>
    <message>
        <source>Event Brush</source>
        <translation>Ereignispinsel</translation>
    </message>
    <message>
        <source>Tag Brush</source>
        <translation>Markenpinsel</translation>
    </message>
    <message>
        <source>Untag Brush</source>
        <translation>Pinsel, der Marken nimmt</translation>
    </message>
    <message>
        <source>Script Brush</source>
        <translation>Skriptpinsel</translation>
    </message>
    <message>
        <source>Walking Style Brush</source>
        <translation>Gangartpinsel</translation>
    </message>
    <message>
        <source>Material Brush</source>
        <translation>Materialpinsel</translation>
    </message>
    <message>
        <source>Group Brush</source>
        <translation>Gruppenpinsel</translation>
    </message>
    <message>
        <source>Restore Brush</source>
        <translation>Wiederherstellungspinsel</translation>
    </message>
    <message>
        <source>Shuffle Brush</source>
        <translation>Mischpinsel</translation>
    </message>
    <message>
        <source>Template Brush</source>
        <translation>Vorlagenpinsel</translation>
    </message>
    <message>
        <source>Clone Brush</source>
        <translation>Klonpinsel</translation>
    </message>
    <message>
        <source>Parts Brush</source>
        <translation>Teilepinsel</translation>
    </message>
    <message>
        <source>Push Brush</source>
        <translation>Schiebepinsel</translation>
    </message>
    <message>
        <source>Smooth Brush</source>
        <translation>Glättpinsel</translation>
    </message>
    <message>
        <source>Time Brush</source>
        <translation>Zeitpinsel</translation>
    </message>
    <message>
        <source>Emotion Brush</source>
        <translation>Stimmungspinsel</translation>
    </message>
    <message>
        <source>Outfit Brush</source>
        <translation>Kleidungspinsel</translation>
    </message>
    <message>
        <source>Relation Brush</source>
        <translation>Beziehungspinsel</translation>
    </message>
    <message>
        <source>Retake Brush</source>
        <translation>Neuspielpinsel</translation>
    </message>
    <message>
        <source>Size Brush</source>
        <translation>Größenpinsel</translation>
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
        <source>Add camera “%1”</source>
        <translation>Kamera „%1“ hinzufügen</translation>
    </message>
    <message>
        <source>Update camera “%1”</source>
        <translation>Kamera „%1“ aktualisieren</translation>
    </message>
    <message>
        <source>Remove camera “%1”</source>
        <translation>Kamera „%1“ entfernen</translation>
    </message>
    <message>
        <source>Rename camera “%1”</source>
        <translation>Kamera „%1“ umbenennen</translation>
    </message>
    <message>
        <source>Look of camera “%1”</source>
        <translation>Look der Kamera „%1“</translation>
    </message>
</context>
<context>
    <name>crowd::app::AssetController</name>
    <message>
        <source>glTF models (*.glb *.gltf);;All files (*)</source>
        <translation>glTF-Modelle (*.glb *.gltf);;Alle Dateien (*)</translation>
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
        <translation>„%1“ ist bereit: Der Pinsel „Erschaffen“ malt damit.</translation>
    </message>
    <message>
        <source>The stage could not be imported</source>
        <translation>Die Bühne konnte nicht importiert werden</translation>
    </message>
    <message>
        <source>Locate “%1” (%2)</source>
        <translation>„%1“ suchen (%2)</translation>
    </message>
    <message>
        <source>The file could not be read</source>
        <translation>Die Datei konnte nicht gelesen werden</translation>
    </message>
    <message numerus="yes">
        <source>%n asset(s) found.</source>
        <translation>
            <numerusform>Eine Datei gefunden.</numerusform>
            <numerusform>%n Dateien gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Import template</source>
        <translation>Vorlage importieren</translation>
    </message>
    <message>
        <source>Import stage</source>
        <translation>Bühne importieren</translation>
    </message>
    <message>
        <source>Remove template</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Locate assets</source>
        <translation>Dateien suchen</translation>
    </message>
    <message>
        <source>Import Templates</source>
        <translation>Vorlagen importieren</translation>
    </message>
    <message>
        <source>Reading the library…</source>
        <translation>Bibliothek wird gelesen …</translation>
    </message>
    <message>
        <source>There is no library</source>
        <translation>Es gibt keine Bibliothek</translation>
    </message>
    <message>
        <source>The built-in characters were not found. Install them beside the program or name their folder in CROWDBRUSH_RESOURCES.</source>
        <translation>Die mitgelieferten Figuren wurden nicht gefunden. Sie neben dem Programm installieren oder ihren Ordner in CROWDBRUSH_RESOURCES nennen.</translation>
    </message>
    <message numerus="yes">
        <source>Add %n template(s)</source>
        <translation>
            <numerusform>%n Vorlage hinzufügen</numerusform>
            <numerusform>%n Vorlagen hinzufügen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n template(s) ready: the create brush paints them.</source>
        <translation>
            <numerusform>Eine Vorlage ist bereit: Der Pinsel „Erschaffen“ malt damit.</numerusform>
            <numerusform>%n Vorlagen sind bereit: Der Pinsel „Erschaffen“ malt damit.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters are of this template; delete them first.</source>
        <translation>
            <numerusform>%n Figur ist von dieser Vorlage; zuerst löschen.</numerusform>
            <numerusform>%n Figuren sind von dieser Vorlage; zuerst löschen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Change clips</source>
        <translation>Clips ändern</translation>
    </message>
    <message>
        <source>Import %1 (%2 of %3)</source>
        <translation>%1 importieren (%2 von %3)</translation>
    </message>
    <message numerus="yes">
        <source>The same for the %n other file(s)</source>
        <translation>
            <numerusform>Dasselbe für die andere Datei</numerusform>
            <numerusform>Dasselbe für die %n anderen Dateien</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::app::Autosaver</name>
    <message>
        <source>Unsaved work is not kept for the case of a crash. %1</source>
        <translation>Ungespeicherte Arbeit wird nicht für den Fall eines Absturzes aufgehoben. %1</translation>
    </message>
</context>
<context>
    <name>crowd::app::CameraBookmarks</name>
    <message>
        <source>The scene has no camera %1. %2 keeps this view as one.</source>
        <translation>Die Szene hat keine Kamera %1. %2 merkt diese Ansicht als eine.</translation>
    </message>
    <message>
        <source>Camera %1, “%2”, shows this view.</source>
        <translation>Kamera %1, „%2“, zeigt diese Ansicht.</translation>
    </message>
    <message>
        <source>The scene has no cameras</source>
        <translation>Die Szene hat keine Kameras</translation>
    </message>
    <message>
        <source>New Camera</source>
        <translation>Neue Kamera</translation>
    </message>
</context>
<context>
    <name>crowd::app::ConsoleDock</name>
    <message>
        <source>Python Console</source>
        <translation>Python-Konsole</translation>
    </message>
    <message>
        <source>The open scene is &quot;scene&quot;, everything else is in &quot;crowdbrush&quot;. Return runs, Shift+Return starts another line, Tab completes, up and down go through what was typed before.</source>
        <translation>Die offene Szene heißt „scene“, alles Übrige steht in „crowdbrush“. Eingabe führt aus, Umschalt+Eingabe beginnt eine neue Zeile, Tab ergänzt, Auf und Ab blättern in dem, was vorher getippt wurde.</translation>
    </message>
    <message>
        <source>Run a script file</source>
        <translation>Eine Skriptdatei ausführen</translation>
    </message>
    <message>
        <source>Stop the script that runs</source>
        <translation>Das laufende Skript anhalten</translation>
    </message>
    <message>
        <source>Clear what was printed</source>
        <translation>Ausgaben löschen</translation>
    </message>
    <message>
        <source>Run Script</source>
        <translation>Skript ausführen</translation>
    </message>
    <message>
        <source>Python scripts (*.py)</source>
        <translation>Python-Skripte (*.py)</translation>
    </message>
    <message>
        <source>Another script is running: wait for it or stop it first.</source>
        <translation>Ein anderes Skript läuft: warten oder es zuerst anhalten.</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 wird ausgeführt</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>The script that runs does not stop. Close all the same? What it was doing is lost.</source>
        <translation>Das laufende Skript hält nicht an. Trotzdem schließen? Was es gerade tat, geht verloren.</translation>
    </message>
    <message>
        <source>… %1 characters are left out …
</source>
        <translation>… %1 Zeichen sind ausgelassen …
</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Record what is done by hand as a script</source>
        <translation>Als Skript aufzeichnen, was von Hand getan wird</translation>
    </message>
</context>
<context>
    <name>crowd::app::ConsoleInput</name>
    <message>
        <source>Python, for example:  len(scene)</source>
        <translation>Python, zum Beispiel:  len(scene)</translation>
    </message>
</context>
<context>
    <name>crowd::app::DialogTask</name>
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
        <translation>Ungespeicherte Arbeit wiederherstellen</translation>
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
        <translation>Szene speichern unter</translation>
    </message>
    <message>
        <source>The scene could not be saved</source>
        <translation>Die Szene konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
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
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes. Save them?</source>
        <translation>„%1“ hat ungespeicherte Änderungen. Speichern?</translation>
    </message>
    <message>
        <source>Loading %1…</source>
        <translation>%1 wird geladen …</translation>
    </message>
    <message>
        <source>Another scene is being opened; wait for it or cancel it first.</source>
        <translation>Eine andere Szene wird gerade geöffnet; warten oder sie zuerst abbrechen.</translation>
    </message>
    <message>
        <source>Finish or cancel (Esc) what you are doing first.</source>
        <translation>Erst beenden oder abbrechen (Esc), was gerade geschieht.</translation>
    </message>
    <message>
        <source>%1 is not there any more. It was moved, renamed or deleted; choose File &gt; Open to look for it.</source>
        <translation>%1 ist nicht mehr da. Die Datei wurde verschoben, umbenannt oder gelöscht; mit Datei &gt; Öffnen lässt sie sich suchen.</translation>
    </message>
    <message>
        <source>Crowdbrush kept unsaved changes of “%1” from %2. Recover them?

Thrown away, they are gone and the scene opens as it was saved.</source>
        <translation>Crowdbrush hat ungespeicherte Änderungen an „%1“ vom %2 aufgehoben. Wiederherstellen?

Verworfen sind sie fort, und die Szene öffnet sich, wie sie gespeichert wurde.</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Throw Away</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Crowdbrush kept a scene that was never saved, from %1. Recover it?

Thrown away, it is gone.</source>
        <translation>Crowdbrush hat eine nie gespeicherte Szene vom %1 aufgehoben. Wiederherstellen?

Verworfen ist sie fort.</translation>
    </message>
    <message>
        <source>Changed on Disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here. Saving replaces that version.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert, seit die Szene hier geöffnet wurde. Speichern ersetzt jene Fassung.</translation>
    </message>
    <message>
        <source>&amp;Replace It</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>To keep both, cancel and choose File &gt; Save As.</source>
        <translation>Um beide zu behalten: abbrechen und Datei &gt; Speichern unter wählen.</translation>
    </message>
    <message>
        <source>“%1” exists already. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>These files are missing and could not be collected:</source>
        <translation>Diese Dateien fehlen und konnten nicht eingesammelt werden:</translation>
    </message>
    <message>
        <source>Collect assets</source>
        <translation>Dateien sammeln</translation>
    </message>
    <message>
        <source>Save Scene As: Its Files Are Collected Beside It</source>
        <translation>Szene speichern unter: Ihre Dateien werden daneben gesammelt</translation>
    </message>
    <message>
        <source>&amp;Not Now</source>
        <translation>&amp;Jetzt nicht</translation>
    </message>
    <message numerus="yes">
        <source>It has %n character(s).</source>
        <translation>
            <numerusform>Sie hat %n Figur.</numerusform>
            <numerusform>Sie hat %n Figuren.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Stage: %2.</source>
        <translation>%1 Bühne: %2.</translation>
    </message>
</context>
<context>
    <name>crowd::app::Interpreter</name>
    <message>
        <source>Finish or cancel the stroke first.</source>
        <translation>Erst den Strich beenden oder abbrechen.</translation>
    </message>
</context>
<context>
    <name>crowd::app::KeysDialog</name>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
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
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>goes to the point under the cursor</source>
        <translation>geht auf den Punkt unter dem Zeiger zu</translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation>+ und −</translation>
    </message>
    <message>
        <source>Shift + F</source>
        <translation>Umschalt + F</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Painting with a brush</source>
        <translation>Mit einem Pinsel malen</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Taste</translation>
    </message>
    <message>
        <source>paints in a circle</source>
        <translation>malt in einem Kreis</translation>
    </message>
    <message>
        <source>paints in a rectangle</source>
        <translation>malt in einem Rechteck</translation>
    </message>
    <message>
        <source>paints; Escape takes the stroke back</source>
        <translation>malt; Esc nimmt den Strich zurück</translation>
    </message>
    <message>
        <source>%1 and %2, Ctrl + wheel</source>
        <translation>%1 und %2, Strg + Rad</translation>
    </message>
    <message>
        <source>smaller and larger brush; dragging with Shift does it too</source>
        <translation>kleinerer und größerer Pinsel; auch durch Ziehen mit Umschalt</translation>
    </message>
    <message>
        <source>the brush’s main number: how many, how strong</source>
        <translation>die wichtigste Zahl des Pinsels: wie viele, wie stark</translation>
    </message>
    <message>
        <source>Selecting</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Click, or drag a rectangle</source>
        <translation>Klicken oder ein Rechteck ziehen</translation>
    </message>
    <message>
        <source>selects; Shift adds, Ctrl changes</source>
        <translation>wählt aus; Umschalt fügt dazu, Strg kehrt um</translation>
    </message>
    <message>
        <source>Drag somebody</source>
        <translation>Jemanden ziehen</translation>
    </message>
    <message>
        <source>moves those who are selected, to free seats or the ground</source>
        <translation>versetzt die Ausgewählten, auf freie Sitze oder den Boden</translation>
    </message>
    <message>
        <source>selects nobody</source>
        <translation>wählt niemanden aus</translation>
    </message>
    <message>
        <source>Looking around</source>
        <translation>Sich umsehen</translation>
    </message>
    <message>
        <source>orbits; with Shift it pans, with Ctrl it comes nearer</source>
        <translation>umkreist; mit Umschalt verschiebt es, mit Strg kommt es näher</translation>
    </message>
    <message>
        <source>Space or Alt held</source>
        <translation>Leertaste oder Alt gehalten</translation>
    </message>
    <message>
        <source>left orbits, middle pans, right comes nearer</source>
        <translation>links umkreist, Mitte verschiebt, rechts kommt näher</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>show those who are selected; show everything</source>
        <translation>die Ausgewählten zeigen; alles zeigen</translation>
    </message>
    <message>
        <source>1 to 9, Ctrl + 1 to 9</source>
        <translation>1 bis 9, Strg + 1 bis 9</translation>
    </message>
    <message>
        <source>go to a camera; keep this view as that camera</source>
        <translation>zu einer Kamera gehen; diese Ansicht als die Kamera merken</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>from the front, the side, above; also with Alt and the digit</source>
        <translation>von vorn, von der Seite, von oben; auch mit Alt und der Ziffer</translation>
    </message>
    <message>
        <source>perspective or orthographic</source>
        <translation>Perspektive oder Parallelprojektion</translation>
    </message>
    <message>
        <source>flies: W A S D, Q and E, the wheel for the speed, a click lands</source>
        <translation>fliegt: W A S D, Q und E, das Rad für das Tempo, ein Klick landet</translation>
    </message>
    <message>
        <source>Playing and the window</source>
        <translation>Abspielen und das Fenster</translation>
    </message>
    <message>
        <source>Space tapped</source>
        <translation>Leertaste getippt</translation>
    </message>
    <message>
        <source>plays and pauses</source>
        <translation>spielt und hält an</translation>
    </message>
    <message>
        <source>hides the panels, and brings them back</source>
        <translation>verbirgt die Bereiche und holt sie zurück</translation>
    </message>
    <message>
        <source>fills the screen</source>
        <translation>füllt den Bildschirm</translation>
    </message>
    <message>
        <source>The preferences change them</source>
        <translation>Die Einstellungen ändern sie</translation>
    </message>
    <message>
        <source>Paths and behaviour</source>
        <translation>Wege und Verhalten</translation>
    </message>
    <message>
        <source>Click with the path brush</source>
        <translation>Klick mit dem Wegpinsel</translation>
    </message>
    <message>
        <source>adds a place; on the first place: closes it</source>
        <translation>fügt einen Ort hinzu; auf dem ersten Ort: schließt ihn</translation>
    </message>
    <message>
        <source>ends the path; the next click begins another one</source>
        <translation>beendet den Weg; der nächste Klick beginnt einen neuen</translation>
    </message>
    <message>
        <source>Drag a place, or its circle</source>
        <translation>Einen Ort oder seinen Kreis ziehen</translation>
    </message>
    <message>
        <source>moves it, or changes its size (selection)</source>
        <translation>versetzt ihn oder ändert seine Größe (Auswahl)</translation>
    </message>
    <message>
        <source>keeps everybody where they are now</source>
        <translation>behält alle, wo sie jetzt sind</translation>
    </message>
    <message>
        <source>paints one character or place</source>
        <translation>malt eine Figur oder einen Ort</translation>
    </message>
    <message>
        <source>At a Glance</source>
        <translation>Auf einen Blick</translation>
    </message>
    <message>
        <source>Save to &amp;Print…</source>
        <translation>Zum &amp;Drucken speichern …</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>%1 to 9</source>
        <translation>%1 bis 9</translation>
    </message>
    <message>
        <source>recall a state of the crowd</source>
        <translation>ruft einen Zustand der Menge ab</translation>
    </message>
    <message>
        <source>keep it, or who is selected, as that state</source>
        <translation>merkt sie, oder die Ausgewählten, als diesen Zustand</translation>
    </message>
    <message>
        <source>Save the Card</source>
        <translation>Übersicht speichern</translation>
    </message>
    <message>
        <source>Pages to print (*.pdf)</source>
        <translation>Seiten zum Drucken (*.pdf)</translation>
    </message>
    <message>
        <source>Quick Reference Card</source>
        <translation>Kurzübersicht</translation>
    </message>
    <message>
        <source>one step on, one back; to the latest moment of the run</source>
        <translation>ein Schritt vor, einer zurück; zum neuesten Augenblick des Laufs</translation>
    </message>
    <message>
        <source>back to the start, everybody where the scene has them</source>
        <translation>zurück zum Anfang, alle dort, wo die Szene sie hat</translation>
    </message>
    <message>
        <source>goes on from the moment shown and forgets what came after it</source>
        <translation>geht vom gezeigten Augenblick an weiter und vergisst, was danach kam</translation>
    </message>
    <message>
        <source>finds actions, brushes, panels and settings by name</source>
        <translation>findet Aktionen, Pinsel, Bedienfelder und Einstellungen beim Namen</translation>
    </message>
</context>
<context>
    <name>crowd::app::MainWindow</name>
    <message>
        <source>%1[*] – Crowdbrush</source>
        <translation>%1[*] – Crowdbrush</translation>
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
        <source>About Crowdbrush</source>
        <translation>Über Crowdbrush</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1 brings the panels back.</source>
        <translation>%1 holt die Bereiche zurück.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Crowdbrush %1&lt;/h3&gt;&lt;p&gt;Paint crowds.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Crowdbrush %1&lt;/h3&gt;&lt;p&gt;Menschenmengen malen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;After “Crowdbrush: Interactive Authoring of Real-time Crowd Scenes” by Branislav Ulicny, Pablo de Heras Ciechomski and Daniel Thalmann, SCA 2004.&lt;/p&gt;&lt;p&gt;MIT licence. Made with Qt %1, GLM, Embree, tinygltf, meshoptimizer and oneTBB.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nach „Crowdbrush: Interactive Authoring of Real-time Crowd Scenes“ von Branislav Ulicny, Pablo de Heras Ciechomski und Daniel Thalmann, SCA 2004.&lt;/p&gt;&lt;p&gt;MIT-Lizenz. Gemacht mit Qt %1, GLM, Embree, tinygltf, meshoptimizer und oneTBB.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
    <message>
        <source>Speed of play</source>
        <translation>Abspieltempo</translation>
    </message>
    <message numerus="yes">
        <source>%n characters are kept where they are</source>
        <translation>
            <numerusform>Eine Figur bleibt, wo sie ist</numerusform>
            <numerusform>%n Figuren bleiben, wo sie sind</numerusform>
        </translation>
    </message>
    <message>
        <source>The language changes when what is going on has ended.</source>
        <translation>Die Sprache wechselt, sobald zu Ende ist, was gerade läuft.</translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Time shown: minutes and seconds from the start</source>
        <translation>Gezeigte Zeit: Minuten und Sekunden vom Anfang an</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Bedienfeld</translation>
    </message>
    <message>
        <source>Shows the panel</source>
        <translation>Zeigt das Bedienfeld</translation>
    </message>
    <message>
        <source>This field cannot be changed now.</source>
        <translation>Dieses Feld lässt sich gerade nicht ändern.</translation>
    </message>
</context>
<context>
    <name>crowd::app::MovieController</name>
    <message>
        <source>Another movie is still being made.</source>
        <translation>Ein anderer Film wird noch gemacht.</translation>
    </message>
    <message>
        <source>Make Movie</source>
        <translation>Film machen</translation>
    </message>
    <message>
        <source>movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Making the movie…</source>
        <translation>Der Film wird gemacht …</translation>
    </message>
    <message>
        <source>Made %1</source>
        <translation>%1 gemacht</translation>
    </message>
    <message>
        <source>The movie could not be made</source>
        <translation>Der Film konnte nicht gemacht werden</translation>
    </message>
    <message>
        <source>Numbered pictures, %1</source>
        <translation>Nummerierte Bilder, %1</translation>
    </message>
    <message numerus="yes">
        <source>%n of the pictures are there already.</source>
        <translation>
            <numerusform>Eines der Bilder ist schon da.</numerusform>
            <numerusform>%n der Bilder sind schon da.</numerusform>
        </translation>
    </message>
    <message>
        <source>Draw What Is Missing</source>
        <translation>Fehlende zeichnen</translation>
    </message>
    <message>
        <source>Draw All Anew</source>
        <translation>Alle neu zeichnen</translation>
    </message>
</context>
<context>
    <name>crowd::app::MovieDialog</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Make Movie</source>
        <translation>Film machen</translation>
    </message>
    <message>
        <source>The view as it is</source>
        <translation>Die Ansicht, wie sie ist</translation>
    </message>
    <message>
        <source>Make…</source>
        <translation>Machen …</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>What has been played</source>
        <translation>Was abgespielt wurde</translation>
    </message>
    <message>
        <source>What has been played, with all that was sent, called and recalled meanwhile; or the scene as it plays if nobody touches it</source>
        <translation>Was abgespielt wurde, mit allem, was dabei gesendet, gerufen und abgerufen wurde; oder die Szene, wie sie abläuft, wenn niemand eingreift</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Wovon</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>%1 pictures a second</source>
        <translation>%1 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Bildrate</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>As the timeline moves it</source>
        <translation>Wie die Zeitleiste sie bewegt</translation>
    </message>
    <message>
        <source>Once around what the view looks at</source>
        <translation>Einmal um das, was die Ansicht anblickt</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>For numbered pictures that are put over others</source>
        <translation>Für nummerierte Bilder, die über andere gelegt werden</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>The scene as it plays by itself</source>
        <translation>Die Szene, wie sie von selbst läuft</translation>
    </message>
</context>
<context>
    <name>crowd::app::PassFields</name>
    <message>
        <source>For compositing: a layer of an OpenEXR file, or a PNG of its own beside that of the colours</source>
        <translation>Für das Compositing: eine Ebene einer OpenEXR-Datei, oder ein eigenes PNG neben dem der Farben</translation>
    </message>
    <message>
        <source>For compositing: layers of an OpenEXR file alone</source>
        <translation>Für das Compositing: Ebenen, nur in OpenEXR-Dateien</translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureController</name>
    <message>
        <source>Another picture is still being drawn.</source>
        <translation>Ein anderes Bild wird noch gezeichnet.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Saving the picture…</source>
        <translation>Das Bild wird gespeichert …</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>The picture could not be saved</source>
        <translation>Das Bild konnte nicht gespeichert werden</translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureDialog</name>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Without sky and ground plane, to be laid over something else. Not as JPEG.</source>
        <translation>Ohne Himmel und Bodenfläche, um es über etwas anderes zu legen. Nicht als JPEG.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Schärfentiefe</translation>
    </message>
    <message>
        <source>What is nearer or farther than a distance is soft, as through a lens. Drawing takes longer.</source>
        <translation>Was näher oder ferner als eine Entfernung ist, wird unscharf, wie durch eine Linse. Das Zeichnen dauert länger.</translation>
    </message>
    <message>
        <source>An orthographic camera has no lens: everything is sharp.</source>
        <translation>Eine orthographische Kamera hat keine Linse: Alles ist scharf.</translation>
    </message>
    <message>
        <source>What the camera turns around</source>
        <translation>Worum sich die Kamera dreht</translation>
    </message>
    <message>
        <source>Who is selected</source>
        <translation>Wer ausgewählt ist</translation>
    </message>
    <message>
        <source>Another distance</source>
        <translation>Andere Entfernung</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>The opening of the lens: the smaller the number, the less is sharp. 1 to 8 as of a camera for photographs, 0.1 as of a model on a table</source>
        <translation>Die Öffnung der Linse: Je kleiner die Zahl, desto weniger ist scharf. 1 bis 8 wie bei einem Fotoapparat, 0,1 wie bei einem Modell auf dem Tisch</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>F-stop</source>
        <translation>Blende</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Ebenen</translation>
    </message>
</context>
<context>
    <name>crowd::app::PictureSizeFields</name>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadratisch</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>8K</source>
        <translation>8K</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>Seitenverhältnis beibehalten</translation>
    </message>
    <message>
        <source>A new width gives a new height, and the other way round</source>
        <translation>Eine neue Breite gibt eine neue Höhe und umgekehrt</translation>
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
        <source>Keep unsaved work every</source>
        <translation>Ungespeichertes aufheben alle</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Whose animation finds no room stands still.</source>
        <translation>Wessen Animation keinen Platz findet, steht still.</translation>
    </message>
    <message>
        <source>Mouse buttons of the brushes</source>
        <translation>Maustasten der Pinsel</translation>
    </message>
    <message>
        <source>Show the welcome page</source>
        <translation>Willkommensseite zeigen</translation>
    </message>
    <message>
        <source>At start</source>
        <translation>Beim Start</translation>
    </message>
    <message>
        <source>The language changes when this page closes.</source>
        <translation>Die Sprache wechselt, wenn diese Seite schließt.</translation>
    </message>
    <message>
        <source>What exceeds it is kept in a temporary file on disk.</source>
        <translation>Was darüber hinausgeht, kommt in eine temporäre Datei auf der Platte.</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Speicher für Rückgängig</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Am besten</translation>
    </message>
    <message>
        <source>Automatic: smooth while it can keep up, and perfect when nothing moves. Fast spares an old machine; best is always smooth.</source>
        <translation>Automatisch: glatt, solange es mithält, und vollkommen, wenn sich nichts bewegt. Schnell schont alte Rechner; am besten ist immer glatt.</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Qualität des Bildes</translation>
    </message>
    <message>
        <source>Take back short strokes in a row together</source>
        <translation>Kurze Striche hintereinander zusammen rückgängig machen</translation>
    </message>
    <message>
        <source>Clicks and dabs that follow each other within a second</source>
        <translation>Klicks und Tupfer, die innerhalb einer Sekunde aufeinander folgen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Memory for prepared animations</source>
        <translation>Speicher für vorbereitete Animationen</translation>
    </message>
    <message>
        <source>Found in the picture</source>
        <translation>Im Bild gesucht</translation>
    </message>
    <message numerus="yes">
        <source>%n samples a pixel</source>
        <translation>
            <numerusform>%n Abtastung je Pixel</numerusform>
            <numerusform>%n Abtastungen je Pixel</numerusform>
        </translation>
    </message>
    <message>
        <source>While something moves, and as many as the graphics card offers. A picture that rests is always smooth.</source>
        <translation>Während sich etwas bewegt, und so viele, wie die Grafikkarte anbietet. Ein Bild, das ruht, ist immer glatt.</translation>
    </message>
    <message>
        <source>Smooth edges</source>
        <translation>Glatte Kanten</translation>
    </message>
</context>
<context>
    <name>crowd::app::RecordPanel</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the whole script</source>
        <translation>Das ganze Skript kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save the script, with the scene that it starts from</source>
        <translation>Das Skript speichern, samt der Szene, mit der es anfängt</translation>
    </message>
    <message>
        <source>What you do by hand appears here as Python.</source>
        <translation>Was von Hand getan wird, erscheint hier als Python.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recorded script</source>
        <translation>Aufgezeichnetes Skript</translation>
    </message>
    <message>
        <source>%1
# … %2 more characters of this step are copied and saved …
</source>
        <translation>%1
# … %2 weitere Zeichen dieses Schritts werden kopiert und gespeichert …
</translation>
    </message>
    <message>
        <source>Save Recorded Script</source>
        <translation>Aufgezeichnetes Skript speichern</translation>
    </message>
    <message>
        <source>recorded.py</source>
        <translation>aufgezeichnet.py</translation>
    </message>
    <message>
        <source>Python scripts (*.py)</source>
        <translation>Python-Skripte (*.py)</translation>
    </message>
</context>
<context>
    <name>crowd::app::Recorder</name>
    <message>
        <source>The recording starts anew: this step was done before it began.</source>
        <translation>Die Aufzeichnung beginnt neu: Dieser Schritt geschah vor ihrem Anfang.</translation>
    </message>
    <message>
        <source>The recording ended: another scene is open now.</source>
        <translation>Die Aufzeichnung ist zu Ende: Jetzt ist eine andere Szene offen.</translation>
    </message>
    <message>
        <source>Recorded as what came of it, not as a stroke: %1.</source>
        <translation>Aufgezeichnet ist, was daraus wurde, nicht der Strich: %1.</translation>
    </message>
</context>
<context>
    <name>crowd::app::ScriptGuard</name>
    <message>
        <source>A script is running: wait for it, or stop it in the console.</source>
        <translation>Ein Skript läuft: warten oder es in der Konsole anhalten.</translation>
    </message>
</context>
<context>
    <name>crowd::app::ShortcutsPage</name>
    <message>
        <source>Search for an action or its keys</source>
        <translation>Nach einer Aktion oder ihren Tasten suchen</translation>
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
        <source>All Back to Defaults</source>
        <translation>Alle zurück auf Vorgaben</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 gehört zu „%2“.</translation>
    </message>
    <message>
        <source>Give It to “%1”</source>
        <translation>An „%1“ geben</translation>
    </message>
    <message>
        <source>Click a field and press the keys.</source>
        <translation>In ein Feld klicken und die Tasten drücken.</translation>
    </message>
</context>
<context>
    <name>crowd::app::StateKeys</name>
    <message>
        <source>The scene has no state %1. %2 keeps the crowd as one.</source>
        <translation>Die Szene hat keinen Zustand %1. %2 merkt die Menge als einen.</translation>
    </message>
    <message>
        <source>The scene has no states yet</source>
        <translation>Die Szene hat noch keine Zustände</translation>
    </message>
    <message>
        <source>New State</source>
        <translation>Neuer Zustand</translation>
    </message>
    <message>
        <source>“%1” keeps how they are now; it is number %2 of the states: %3 recalls it</source>
        <translation>„%1“ merkt sich, wie sie jetzt sind; es ist Nummer %2 der Zustände: %3 ruft ihn ab</translation>
    </message>
</context>
<context>
    <name>crowd::app::StatusPanel</name>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n in view</source>
        <translation>
            <numerusform>eine im Bild</numerusform>
            <numerusform>%n im Bild</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 ms · %2 fps</source>
        <translation>%1 ms · %2 Bilder/s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Time of one picture: %1 triangles in %2 draws</source>
        <translation>Zeit eines Bildes: %1 Dreiecke in %2 Aufrufen</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n have left</source>
        <translation>
            <numerusform>eine ist fort</numerusform>
            <numerusform>%n sind fort</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding out where characters can walk…</source>
        <translation>Herausfinden, wo man gehen kann …</translation>
    </message>
    <message>
        <source>plays at × %1</source>
        <translation>spielt mit × %1</translation>
    </message>
    <message>
        <source>This machine cannot compute what the crowd does as fast as it is to play.</source>
        <translation>Dieser Rechner kann nicht so schnell berechnen, was die Menge tut, wie sie spielen soll.</translation>
    </message>
    <message>
        <source>What came after %1 s is played anew</source>
        <translation>Was nach %1 s kam, wird neu gespielt</translation>
    </message>
    <message>
        <source>Too much was edited since it was started: this happens at the latest moment. Stop and play to go back to any moment again.</source>
        <translation>Seit dem Start wurde zu viel geändert: Das geschieht im letzten Augenblick. Halten Sie an und spielen Sie neu, um wieder zu jedem Augenblick zurückzukehren.</translation>
    </message>
    <message>
        <source>as in &quot;%1&quot;</source>
        <translation>wie in „%1“</translation>
    </message>
    <message>
        <source>Played on out of &quot;%1&quot; from %2 s; the take stays as it is</source>
        <translation>Aus „%1“ heraus wird ab %2 s weitergespielt; der Take bleibt, wie er ist</translation>
    </message>
    <message>
        <source>The play range of the timeline ends here. A click on its ruler with Shift held: all time is played.</source>
        <translation>Hier endet der Abspielbereich der Zeitleiste. Ein Klick auf ihr Lineal mit Umschalt: die ganze Zeit wird abgespielt.</translation>
    </message>
    <message>
        <source>Memory of the graphics card: %1</source>
        <translation>Speicher der Grafikkarte: %1</translation>
    </message>
</context>
<context>
    <name>crowd::app::StrokePainter</name>
    <message>
        <source>A script is running: wait for it, or stop it in the console.</source>
        <translation>Ein Skript läuft: warten oder es in der Konsole anhalten.</translation>
    </message>
    <message>
        <source>The stroke was taken back.</source>
        <translation>Der Strich wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>%1 stopped: %2</source>
        <translation>%1 hielt an: %2</translation>
    </message>
    <message>
        <source>%1 is at work</source>
        <translation>%1 arbeitet</translation>
    </message>
</context>
<context>
    <name>crowd::app::TimeSlider</name>
    <message>
        <source>The run so far: drag to see any moment of it again. What is done to people then happens there, and what came after is played anew.</source>
        <translation>Der Lauf bis jetzt: ziehen, um jeden Augenblick wieder zu sehen. Was dann mit Figuren geschieht, geschieht dort, und was danach kam, wird neu gespielt.</translation>
    </message>
</context>
<context>
    <name>crowd::app::WelcomeHint</name>
    <message>
        <source>Close, and do not show this again</source>
        <translation>Schließen und nicht wieder zeigen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; over free seats or open ground: characters come. &amp;nbsp;&lt;b&gt;Right click&lt;/b&gt;: the brushes.&lt;br&gt;&lt;b&gt;Space&lt;/b&gt; and drag: look around. &amp;nbsp;&lt;b&gt;Ctrl+Z&lt;/b&gt;: take it back. &amp;nbsp;&lt;b&gt;F1&lt;/b&gt;: all keys.</source>
        <translation>&lt;b&gt;Ziehen&lt;/b&gt; über freie Sitze oder freien Boden: Figuren kommen. &amp;nbsp;&lt;b&gt;Rechtsklick&lt;/b&gt;: die Pinsel.&lt;br&gt;&lt;b&gt;Leertaste&lt;/b&gt; und ziehen: umsehen. &amp;nbsp;&lt;b&gt;Strg+Z&lt;/b&gt;: zurücknehmen. &amp;nbsp;&lt;b&gt;F1&lt;/b&gt;: alle Tasten.</translation>
    </message>
</context>
<context>
    <name>crowd::model::SceneDocument</name>
    <message>
        <source>Finish or cancel (Esc) what you are doing first.</source>
        <translation>Erst beenden oder abbrechen (Esc), was gerade geschieht.</translation>
    </message>
    <message>
        <source>This step cannot be taken: %1. The scene is unharmed; save it. What was done since can still be undone and redone.</source>
        <translation>Dieser Schritt geht nicht: %1. Die Szene ist unversehrt; bitte speichern. Was seither getan wurde, lässt sich weiter zurücknehmen und wiederholen.</translation>
    </message>
    <message>
        <source>Undo takes %1 MB of memory and cannot use the disk: %2. Nothing is lost; make room there, or save and reopen the scene to forget its undo steps.</source>
        <translation>Rückgängig belegt %1 MB Speicher und kann die Platte nicht benutzen: %2. Nichts ist verloren; dort Platz schaffen, oder die Szene speichern und neu öffnen, um ihre Schritte zu vergessen.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::BranchList</name>
    <message>
        <source>Some leave it:</source>
        <translation>Einige verlassen ihn:</translation>
    </message>
    <message>
        <source>+ branch to another path</source>
        <translation>+ Abzweig zu einem anderen Weg</translation>
    </message>
    <message>
        <source>There is no other path yet</source>
        <translation>Es gibt noch keinen anderen Weg</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>Change a branch</source>
        <translation>Abzweig ändern</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>Change the weight of a branch</source>
        <translation>Gewicht eines Abzweigs ändern</translation>
    </message>
    <message>
        <source>So many go over for each one who goes on: at 1, half of them</source>
        <translation>So viele wechseln für jeden, der weitergeht: bei 1 die Hälfte</translation>
    </message>
    <message>
        <source>Remove this branch</source>
        <translation>Diesen Abzweig entfernen</translation>
    </message>
    <message>
        <source>Remove a branch</source>
        <translation>Abzweig entfernen</translation>
    </message>
    <message>
        <source>Add a branch</source>
        <translation>Abzweig hinzufügen</translation>
    </message>
    <message>
        <source>Let some characters go over to another path at a place</source>
        <translation>Einige Figuren an einem Ort auf einen anderen Weg wechseln lassen</translation>
    </message>
    <message>
        <source> × as often</source>
        <translation> × so oft</translation>
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
        <translation>Fläche</translation>
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
        <source>Script Brush: %1</source>
        <translation>Skriptpinsel: %1</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CameraDirector</name>
    <message>
        <source>The view is yours: the timeline does not move it any more. View &gt; Follow the Timeline gives it back.</source>
        <translation>Die Ansicht gehört Ihnen: Die Zeitleiste bewegt sie nicht mehr. Ansicht &gt; Der Zeitleiste folgen gibt sie zurück.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipMix</name>
    <message>
        <source>How often it comes among those ticked</source>
        <translation>Wie oft es unter den angekreuzten vorkommt</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipTable</name>
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
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 (when standing)</source>
        <translation>%1 (im Stehen)</translation>
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
        <source>How far the character gets in a second of this clip</source>
        <translation>Wie weit die Figur in einer Sekunde dieses Clips kommt</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Rolle von %1</translation>
    </message>
    <message>
        <source>What characters stand, walk and sit with. Clips of other roles play only where a brush or a rule asks for them.</source>
        <translation>Womit Figuren stehen, gehen und sitzen. Clips anderer Rollen spielen nur, wo ein Pinsel oder eine Regel danach verlangt.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ClipsDialog</name>
    <message>
        <source>Clips of “%1”</source>
        <translation>Clips von „%1“</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ColourDock</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
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
        <source>Take a colour from somebody in the picture (Ctrl and click with the colour brush)</source>
        <translation>Eine Farbe von jemandem im Bild nehmen (Strg und Klick mit dem Farbpinsel)</translation>
    </message>
    <message>
        <source>Painted with lately</source>
        <translation>Zuletzt gemalt</translation>
    </message>
    <message>
        <source>A right click removes it</source>
        <translation>Ein Rechtsklick entfernt sie</translation>
    </message>
    <message>
        <source>Another colour for random and for gradients</source>
        <translation>Noch eine Farbe für Zufall und Verläufe</translation>
    </message>
    <message>
        <source>Another colour that new characters may wear</source>
        <translation>Noch eine Farbe, die neue Figuren tragen können</translation>
    </message>
    <message>
        <source>A click brings it to the front, from where it paints; a right click removes it</source>
        <translation>Ein Klick holt sie nach vorn, von wo sie malt; ein Rechtsklick entfernt sie</translation>
    </message>
    <message>
        <source>New characters wear these:</source>
        <translation>Neue Figuren tragen diese:</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ColourRow</name>
    <message>
        <source>Add a colour</source>
        <translation>Eine Farbe hinzufügen</translation>
    </message>
    <message>
        <source>Click: change the colour. Right button: take it out.</source>
        <translation>Klick: die Farbe ändern. Rechte Taste: herausnehmen.</translation>
    </message>
    <message>
        <source>Take Out</source>
        <translation>Herausnehmen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CueBar</name>
    <message>
        <source>those tagged %1</source>
        <translation>Figuren mit der Marke %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>There are %1 cues already, as many as can be.</source>
        <translation>Es gibt schon %1 Stichworte, mehr sind nicht möglich.</translation>
    </message>
    <message>
        <source>Add a cue</source>
        <translation>Stichwort hinzufügen</translation>
    </message>
    <message>
        <source>Change a cue</source>
        <translation>Stichwort ändern</translation>
    </message>
    <message>
        <source>Delete a cue</source>
        <translation>Stichwort löschen</translation>
    </message>
    <message>
        <source>+ Cue</source>
        <translation>+ Stichwort</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>A button, with a key if you like, that lets an event happen to characters</source>
        <translation>Eine Schaltfläche, auf Wunsch mit Taste, die Figuren ein Ereignis schickt</translation>
    </message>
    <message>
        <source>“%1” is recalled for %2.</source>
        <translation>„%1“ wird für %2 abgerufen.</translation>
    </message>
    <message>
        <source>Sends “%1” to %2.</source>
        <translation>Sendet „%1“ an %2.</translation>
    </message>
    <message>
        <source>The arrow changes or deletes it.</source>
        <translation>Der Pfeil ändert oder löscht es.</translation>
    </message>
    <message>
        <source>%1 (selected)</source>
        <translation>%1 (Gewählte)</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::CueForm</name>
    <message>
        <source>Cue</source>
        <translation>Stichwort</translation>
    </message>
    <message>
        <source>named as its event</source>
        <translation>heißt wie sein Ereignis</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>sends</source>
        <translation>sendet</translation>
    </message>
    <message>
        <source>event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>The event’s number, a walking speed for example</source>
        <translation>Die Zahl des Ereignisses, zum Beispiel ein Gehtempo</translation>
    </message>
    <message>
        <source>to</source>
        <translation>an</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>with number</source>
        <translation>mit Zahl</translation>
    </message>
    <message>
        <source>recalls</source>
        <translation>ruft ab</translation>
    </message>
    <message>
        <source>no state</source>
        <translation>keinen Zustand</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>the last after</source>
        <translation>der letzte nach</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Then click in the picture where it begins</source>
        <translation>Dann im Bild anklicken, wo es beginnt</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::DockBase</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentDock</name>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Rename a place</source>
        <translation>Einen Ort umbenennen</translation>
    </message>
    <message>
        <source>Rename a path</source>
        <translation>Einen Weg umbenennen</translation>
    </message>
    <message>
        <source>Move a place</source>
        <translation>Einen Ort versetzen</translation>
    </message>
    <message>
        <source>X, Y, Z, m</source>
        <translation>X, Y, Z, m</translation>
    </message>
    <message>
        <source>Radius, m</source>
        <translation>Radius, m</translation>
    </message>
    <message>
        <source>Resize a place</source>
        <translation>Größe eines Orts ändern</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Change what a place is</source>
        <translation>Ändern, was ein Ort ist</translation>
    </message>
    <message>
        <source>On to the first place</source>
        <translation>Weiter zum ersten Ort</translation>
    </message>
    <message>
        <source>Jump to the first</source>
        <translation>Zum ersten springen</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Change the end of a path</source>
        <translation>Das Ende eines Wegs ändern</translation>
    </message>
    <message>
        <source>Colour in the picture</source>
        <translation>Farbe im Bild</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour a place</source>
        <translation>Einen Ort färben</translation>
    </message>
    <message>
        <source>Colour a path</source>
        <translation>Einen Weg färben</translation>
    </message>
    <message>
        <source>Room for</source>
        <translation>Platz für</translation>
    </message>
    <message>
        <source>Change the room of a place</source>
        <translation>Platz eines Orts ändern</translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation>Tempo, %</translation>
    </message>
    <message>
        <source>Change the speed on slow ground</source>
        <translation>Tempo auf langsamem Boden ändern</translation>
    </message>
    <message>
        <source>No paths yet. Take the path brush (P) and click where characters are to walk; then let characters walk along it with the walk brush (W).</source>
        <translation>Noch keine Wege. Den Wegpinsel nehmen (P) und klicken, wo gegangen werden soll; dann Figuren mit dem Gehpinsel (W) darauf gehen lassen.</translation>
    </message>
    <message>
        <source>all who fit</source>
        <translation>alle, die passen</translation>
    </message>
    <message>
        <source>So many have room, for rules that ask whether it is full or free; 0: as many as can stand in it, two on a square metre, but one where characters line up</source>
        <translation>So viele haben Platz, für Regeln, die nach voll oder frei fragen; 0: so viele, wie darin stehen können, zwei auf einem Quadratmeter, aber nur einer, wo Figuren anstehen</translation>
    </message>
    <message>
        <source>Characters stop</source>
        <translation>Figuren halten an</translation>
    </message>
    <message>
        <source>%1 &lt;a href=&quot;people&quot;&gt;Select them&lt;/a&gt;</source>
        <translation>%1 &lt;a href=&quot;people&quot;&gt;Auswählen&lt;/a&gt;</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Change the shape of a place</source>
        <translation>Die Form eines Ortes ändern</translation>
    </message>
    <message numerus="yes">
        <source>%n corner(s), %1 m²</source>
        <translation>
            <numerusform>%n Ecke, %1 m²</numerusform>
            <numerusform>%n Ecken, %1 m²</numerusform>
        </translation>
    </message>
    <message>
        <source>Half width, m</source>
        <translation>Halbe Breite, m</translation>
    </message>
    <message>
        <source>Margin, m</source>
        <translation>Rand, m</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentMenu</name>
    <message>
        <source>Go On Painting It</source>
        <translation>Weitermalen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Reverse a path</source>
        <translation>Einen Weg umkehren</translation>
    </message>
    <message>
        <source>Delete the Path</source>
        <translation>Den Weg löschen</translation>
    </message>
    <message>
        <source>Delete a path</source>
        <translation>Einen Weg löschen</translation>
    </message>
    <message>
        <source>Delete It with Its Places</source>
        <translation>Samt seinen Orten löschen</translation>
    </message>
    <message>
        <source>Join with</source>
        <translation>Verbinden mit</translation>
    </message>
    <message>
        <source>Join two paths</source>
        <translation>Zwei Wege verbinden</translation>
    </message>
    <message>
        <source>Let the Selected Characters Walk It</source>
        <translation>Die ausgewählten Figuren darauf gehen lassen</translation>
    </message>
    <message>
        <source>Select Its Characters</source>
        <translation>Seine Figuren auswählen</translation>
    </message>
    <message>
        <source>Insert a Place After It</source>
        <translation>Danach einen Ort einfügen</translation>
    </message>
    <message>
        <source>Take It Out of the Path</source>
        <translation>Aus dem Weg nehmen</translation>
    </message>
    <message>
        <source>Delete the Place</source>
        <translation>Den Ort löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n place(s)</source>
        <translation>
            <numerusform>Einen Ort löschen</numerusform>
            <numerusform>%n Orte löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert a place</source>
        <translation>Einen Ort einfügen</translation>
    </message>
    <message>
        <source>Take a place out of a path</source>
        <translation>Einen Ort aus einem Weg nehmen</translation>
    </message>
    <message>
        <source>Nobody is selected: select characters first (V), or paint them with the walk brush (W).</source>
        <translation>Niemand ist ausgewählt: Zuerst Figuren auswählen (V) oder sie mit dem Gehpinsel malen (W).</translation>
    </message>
    <message numerus="yes">
        <source>Let %n character(s) walk</source>
        <translation>
            <numerusform>Eine Figur gehen lassen</numerusform>
            <numerusform>%n Figuren gehen lassen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::EnvironmentTree</name>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Rename a path</source>
        <translation>Einen Weg umbenennen</translation>
    </message>
    <message>
        <source>Rename a place</source>
        <translation>Einen Ort umbenennen</translation>
    </message>
    <message>
        <source>%1 m long</source>
        <translation>%1 m lang</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message numerus="yes">
        <source>%n in it · %1</source>
        <translation>
            <numerusform>%n darin · %1</numerusform>
            <numerusform>%n darin · %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeaturePreview</name>
    <message>
        <source>Nobody of the scene&apos;s templates can show it.</source>
        <translation>Keine Vorlage der Szene kann es zeigen.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeatureRows</name>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FeaturesDock</name>
    <message>
        <source>Features</source>
        <translation>Merkmale</translation>
    </message>
    <message>
        <source>Whoever bears the value becomes what you set here, with it. Else only those are who come to bear it from now on.</source>
        <translation>Wer den Wert trägt, wird mit ihm so, wie es hier eingestellt wird. Sonst nur, wer ihn von jetzt an bekommt.</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>New features, and files of features</source>
        <translation>Neue Merkmale und Dateien mit Merkmalen</translation>
    </message>
    <message>
        <source>Add a value to the feature</source>
        <translation>Dem Merkmal einen Wert hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate the chosen value</source>
        <translation>Den gewählten Wert duplizieren</translation>
    </message>
    <message>
        <source>Select who bears the chosen value</source>
        <translation>Auswählen, wer den gewählten Wert trägt</translation>
    </message>
    <message>
        <source>Remove the chosen value</source>
        <translation>Den gewählten Wert entfernen</translation>
    </message>
    <message>
        <source>Double click or F2: rename</source>
        <translation>Doppelklick oder F2: umbenennen</translation>
    </message>
    <message>
        <source>A feature is what people are like: an emotion, an outfit, a team. The button above adds one.</source>
        <translation>Ein Merkmal ist, wie Leute sind: eine Stimmung, eine Kleidung, ein Team. Der Knopf oben fügt eines hinzu.</translation>
    </message>
    <message>
        <source>The feature has no values yet: + adds one.</source>
        <translation>Das Merkmal hat noch keine Werte: + fügt einen hinzu.</translation>
    </message>
    <message numerus="yes">
        <source>%n bear it and change with it</source>
        <translation>
            <numerusform>%n trägt es und ändert sich mit</numerusform>
            <numerusform>%n tragen es und ändern sich mit</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody bears it yet</source>
        <translation>Noch niemand trägt es</translation>
    </message>
    <message>
        <source>New Feature</source>
        <translation>Neues Merkmal</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Save as a File…</source>
        <translation>Als Datei speichern…</translation>
    </message>
    <message>
        <source>Take from a File…</source>
        <translation>Aus einer Datei übernehmen…</translation>
    </message>
    <message>
        <source>Rename the Feature</source>
        <translation>Merkmal umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Save the Feature</source>
        <translation>Merkmal speichern</translation>
    </message>
    <message>
        <source>Features (*%1)</source>
        <translation>Merkmale (*%1)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>%1 cannot be saved: %2</source>
        <translation>%1 kann nicht gespeichert werden: %2</translation>
    </message>
    <message>
        <source>Take Features</source>
        <translation>Merkmale übernehmen</translation>
    </message>
    <message>
        <source>Features taken from %1</source>
        <translation>Merkmale aus %1 übernommen</translation>
    </message>
    <message>
        <source>Give to who is selected</source>
        <translation>Den Ausgewählten geben</translation>
    </message>
    <message>
        <source>Select who bears it</source>
        <translation>Auswählen, wer es trägt</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Give the chosen value to who is selected, or to all where nobody is</source>
        <translation>Den gewählten Wert allen Ausgewählten geben, oder allen, wo niemand ausgewählt ist</translation>
    </message>
    <message>
        <source>Paint the chosen value</source>
        <translation>Den gewählten Wert malen</translation>
    </message>
    <message>
        <source>Paint It</source>
        <translation>Malen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FieldForm</name>
    <message>
        <source>Scripts bring brushes along: a Python class with apply(selection), made known with crowdbrush.register_brush(MyBrush), has its place in the palette and its settings here.</source>
        <translation>Skripte bringen Pinsel mit: Eine Python-Klasse mit apply(selection), bekannt gemacht mit crowdbrush.register_brush(MyBrush), hat ihren Platz in der Palette und hier ihre Einstellungen.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>Kleidung</translation>
    </message>
    <message>
        <source>All tintable</source>
        <translation>Alle färbbaren</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None: stay</source>
        <translation>Keiner: bleiben</translation>
    </message>
    <message>
        <source>The nearest</source>
        <translation>Dem nächsten</translation>
    </message>
    <message>
        <source>no name yet; the Rules panel gives it one</source>
        <translation>noch ohne Namen; der Bereich Regeln gibt ihr einen</translation>
    </message>
    <message>
        <source>Named</source>
        <translation>Namens</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannte</translation>
    </message>
    <message>
        <source>Choose in the Picture</source>
        <translation>Im Bild wählen</translation>
    </message>
    <message>
        <source>Any, by the operator</source>
        <translation>Irgendeines, nach dem Operator</translation>
    </message>
    <message>
        <source>In no group</source>
        <translation>In keiner Gruppe</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle Teile</translation>
    </message>
    <message>
        <source>Then click the point</source>
        <translation>Dann den Punkt anklicken</translation>
    </message>
    <message>
        <source>Take it out of the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Take whoever is selected</source>
        <translation>Nimmt, wer ausgewählt ist</translation>
    </message>
    <message>
        <source>Nobody is selected: click somebody first.</source>
        <translation>Niemand ist ausgewählt: zuerst jemanden anklicken.</translation>
    </message>
    <message>
        <source>Take the Selected</source>
        <translation>Ausgewählten nehmen</translation>
    </message>
    <message>
        <source>Character %1</source>
        <translation>Figur %1</translation>
    </message>
    <message>
        <source>Character %1, who is gone</source>
        <translation>Figur %1, die nicht mehr da ist</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>All get the value that was ticked first.</source>
        <translation>Alle bekommen den Wert, der zuerst angekreuzt wurde.</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Im Stehen</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Im Gehen</translation>
    </message>
    <message>
        <source>Sitting</source>
        <translation>Im Sitzen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::FindDialog</name>
    <message>
        <source>Find an Action, a Brush, a Panel or a Setting</source>
        <translation>Aktion, Pinsel, Bedienfeld oder Einstellung suchen</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>“%1” would do nothing now: %2</source>
        <translation>„%1“ würde jetzt nichts tun: %2</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>So heißt nichts.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::GroupsDock</name>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>A new group of those who are selected</source>
        <translation>Eine neue Gruppe aus den Ausgewählten</translation>
    </message>
    <message>
        <source>Take the selected characters into the active group</source>
        <translation>Die ausgewählten Figuren in die aktive Gruppe nehmen</translation>
    </message>
    <message>
        <source>Select the characters of the active group</source>
        <translation>Die Figuren der aktiven Gruppe auswählen</translation>
    </message>
    <message>
        <source>Delete the active group; its characters stay</source>
        <translation>Die aktive Gruppe löschen; ihre Figuren bleiben</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>In no group</source>
        <translation>In keiner Gruppe</translation>
    </message>
    <message>
        <source>Hidden: click to show</source>
        <translation>Ausgeblendet: Klick blendet ein</translation>
    </message>
    <message>
        <source>Shown: click to hide, with Alt to show it alone</source>
        <translation>Sichtbar: Klick blendet aus, mit Alt wird nur sie gezeigt</translation>
    </message>
    <message>
        <source>Locked: click to let brushes work on it</source>
        <translation>Gesperrt: Klick lässt Pinsel wieder zu</translation>
    </message>
    <message>
        <source>Click to lock: no brush touches it then</source>
        <translation>Klick sperrt: Kein Pinsel rührt sie dann an</translation>
    </message>
    <message>
        <source>Show or hide a group</source>
        <translation>Gruppe ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Lock or unlock a group</source>
        <translation>Gruppe sperren oder freigeben</translation>
    </message>
    <message>
        <source>Rename a group</source>
        <translation>Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Colour of a group</source>
        <translation>Farbe einer Gruppe</translation>
    </message>
    <message>
        <source>Select These Characters</source>
        <translation>Diese Figuren auswählen</translation>
    </message>
    <message>
        <source>Take the Selected Out of Their Groups</source>
        <translation>Ausgewählte aus ihren Gruppen nehmen</translation>
    </message>
    <message>
        <source>Take the Selected In</source>
        <translation>Ausgewählte aufnehmen</translation>
    </message>
    <message>
        <source>Show It Alone</source>
        <translation>Allein zeigen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe …</translation>
    </message>
    <message>
        <source>Walk as One Party</source>
        <translation>Als eine Gesellschaft gehen</translation>
    </message>
    <message>
        <source>Party or not</source>
        <translation>Gesellschaft oder nicht</translation>
    </message>
    <message>
        <source>All of them take the same branch of a path and keep together</source>
        <translation>Alle nehmen dieselbe Abzweigung eines Weges und bleiben beisammen</translation>
    </message>
    <message>
        <source>Delete the Group</source>
        <translation>Gruppe löschen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New Group of the Selected</source>
        <translation>Neue Gruppe aus den Ausgewählten</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::HandEditsPanel</name>
    <message>
        <source>Edits by hand</source>
        <translation>Von Hand geändert</translation>
    </message>
    <message>
        <source>Off: the take is seen as it was kept</source>
        <translation>Aus: der Take ist zu sehen, wie er behalten wurde</translation>
    </message>
    <message>
        <source>Edit the selected characters of the take</source>
        <translation>Die gewählten Figuren des Takes ändern</translation>
    </message>
    <message>
        <source>Select those whom the chosen edit is for</source>
        <translation>Die wählen, für die die gewählte Änderung ist</translation>
    </message>
    <message>
        <source>Delete the chosen edit</source>
        <translation>Die gewählte Änderung löschen</translation>
    </message>
    <message>
        <source>Later or Earlier</source>
        <translation>Später oder früher</translation>
    </message>
    <message>
        <source>Slower or Faster</source>
        <translation>Langsamer oder schneller</translation>
    </message>
    <message>
        <source>Stand Still</source>
        <translation>Still stehen</translation>
    </message>
    <message>
        <source>Beside Their Way</source>
        <translation>Neben ihrem Weg</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Verborgen</translation>
    </message>
    <message>
        <source>Change an edit</source>
        <translation>Eine Änderung anpassen</translation>
    </message>
    <message numerus="yes">
        <source>%n character(s)</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Somebody Else</source>
        <translation>Jemand anderes</translation>
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
    <message>
        <source>%1 in memory, %2 on disk</source>
        <translation>%1 im Speicher, %2 auf der Platte</translation>
    </message>
    <message>
        <source>%1 in memory</source>
        <translation>%1 im Speicher</translation>
    </message>
    <message>
        <source>%1 in memory: %2</source>
        <translation>%1 im Speicher: %2</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ImportDialog</name>
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
        <translation>Maßstab</translation>
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
        <source>Stay on the spot; the program moves the character</source>
        <translation>Auf der Stelle bleiben; das Programm bewegt die Figur</translation>
    </message>
    <message>
        <source>To the &amp;Ground</source>
        <translation>Auf den &amp;Boden</translation>
    </message>
    <message>
        <source>Raise or lower it until its lowest point is on the ground</source>
        <translation>Heben oder senken, bis der tiefste Punkt den Boden berührt</translation>
    </message>
    <message>
        <source>As &amp;Proposed</source>
        <translation>Wie &amp;vorgeschlagen</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch einer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Import &amp;All</source>
        <translation>&amp;Alle importieren</translation>
    </message>
    <message numerus="yes">
        <source>This one as it is here, and the %n other file(s) as proposed</source>
        <translation>
            <numerusform>Diese, wie sie hier ist, und die andere Datei wie vorgeschlagen</numerusform>
            <numerusform>Diese, wie sie hier ist, und die %n anderen Dateien wie vorgeschlagen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::IndividualDock</name>
    <message>
        <source>Metres along %1</source>
        <translation>Meter entlang %1</translation>
    </message>
    <message>
        <source>Nobody is selected. Press V and click somebody.</source>
        <translation>Niemand ist ausgewählt. V drücken und jemanden anklicken.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;, number %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;, Nummer %2</translation>
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
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Tint of %1</source>
        <translation>Tönung von %1</translation>
    </message>
    <message>
        <source>Number of the seat</source>
        <translation>Nummer des Sitzes</translation>
    </message>
    <message>
        <source>Stand Up</source>
        <translation>Aufstehen</translation>
    </message>
    <message>
        <source>Stand up: the seat is free again</source>
        <translation>Aufstehen: der Sitz ist wieder frei</translation>
    </message>
    <message numerus="yes">
        <source>%n seated</source>
        <translation>
            <numerusform>eine sitzt</numerusform>
            <numerusform>%n sitzen</numerusform>
        </translation>
    </message>
    <message>
        <source>row %1, wedge %2</source>
        <translation>Reihe %1, Keil %2</translation>
    </message>
    <message>
        <source>Tint; a click chooses a colour, a right click takes it off</source>
        <translation>Farbton; ein Klick wählt eine Farbe, ein Rechtsklick nimmt sie weg</translation>
    </message>
    <message>
        <source>Names or numbers of tags from 1 to 64, as brave, 3-5</source>
        <translation>Namen oder Nummern von Marken von 1 bis 64, etwa mutig, 3-5</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Figur</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%n characters&lt;/b&gt;</source>
        <translation>
            <numerusform>&lt;b&gt;%n Figur&lt;/b&gt;</numerusform>
            <numerusform>&lt;b&gt;%n Figuren&lt;/b&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Mode of the tint of %1</source>
        <translation>Modus der Tönung von %1</translation>
    </message>
    <message>
        <source>Whether the tint multiplies the colour that is there or replaces it</source>
        <translation>Ob die Tönung die Farbe darunter multipliziert oder ersetzt</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LibraryDialog</name>
    <message>
        <source>Add from Library</source>
        <translation>Aus Bibliothek hinzufügen</translation>
    </message>
    <message>
        <source>Choose whom to paint with; Ctrl or Shift and a click choose several.</source>
        <translation>Wählen, wer gemalt wird; Strg oder Umschalt und ein Klick wählen mehrere.</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Is in the scene already</source>
        <translation>Ist schon in der Szene</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LightDock</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Ready-Made</source>
        <translation>Fertiges Licht</translation>
    </message>
    <message>
        <source>Sun, sky and colours of a time of day; the ground stays</source>
        <translation>Sonne, Himmel und Farben einer Tageszeit; der Boden bleibt</translation>
    </message>
    <message>
        <source>Add: %1. Then click what it is to shine on</source>
        <translation>Hinzufügen: %1. Dann anklicken, worauf es scheinen soll</translation>
    </message>
    <message>
        <source>Remove the chosen light</source>
        <translation>Das gewählte Licht entfernen</translation>
    </message>
    <message>
        <source>Ticked: it is on. Double click or F2: rename</source>
        <translation>Angehakt: es ist an. Doppelklick oder F2: umbenennen</translation>
    </message>
    <message>
        <source>Sun and sky</source>
        <translation>Sonne und Himmel</translation>
    </message>
    <message numerus="yes">
        <source>%n lights are on; the strongest %1 of them shine.</source>
        <translation>
            <numerusform>%n Licht ist an; die stärksten %1 davon leuchten.</numerusform>
            <numerusform>%n Lichter sind an; die stärksten %1 davon leuchten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename a light</source>
        <translation>Licht umbenennen</translation>
    </message>
    <message>
        <source>Switch a light on</source>
        <translation>Licht einschalten</translation>
    </message>
    <message>
        <source>Switch a light off</source>
        <translation>Licht ausschalten</translation>
    </message>
    <message>
        <source>Change a light</source>
        <translation>Ein Licht ändern</translation>
    </message>
    <message>
        <source>In the picture, while Select is chosen: drag the lamp, with Shift up and down.</source>
        <translation>Im Bild, solange „Auswählen“ gewählt ist: die Lampe ziehen, mit Umschalt auf und ab.</translation>
    </message>
    <message>
        <source>Click what it is to shine on.</source>
        <translation>Anklicken, was es beleuchten soll.</translation>
    </message>
    <message>
        <source>Add: a spotlight that goes with somebody. Then click him</source>
        <translation>Hinzufügen: ein Scheinwerfer, der mit jemandem mitgeht. Dann ihn anklicken</translation>
    </message>
    <message>
        <source>Click whom it is to follow.</source>
        <translation>Anklicken, wem er folgen soll.</translation>
    </message>
    <message>
        <source>It can be dragged in the picture with the tool Select.</source>
        <translation>Es lässt sich im Bild mit dem Werkzeug „Auswählen“ ziehen.</translation>
    </message>
    <message>
        <source>In the picture, while Select is chosen: drag the lamp, with Shift up and down, the edge of its cone, or what it shines on; with Ctrl onto somebody, and it goes with him.</source>
        <translation>Im Bild, solange „Auswählen“ gewählt ist: die Lampe ziehen, mit Umschalt auf und ab, den Rand ihres Kegels oder das, worauf sie scheint; mit Strg auf jemanden, dann folgt sie ihm.</translation>
    </message>
    <message>
        <source>Change sun, sky or air</source>
        <translation>Sonne, Himmel oder Luft ändern</translation>
    </message>
    <message>
        <source>Show the chosen lamp in the picture</source>
        <translation>Die gewählte Lampe im Bild zeigen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::LooksDock</name>
    <message>
        <source>Looks</source>
        <translation>Looks</translation>
    </message>
    <message>
        <source>Add a look</source>
        <translation>Look hinzufügen</translation>
    </message>
    <message>
        <source>Remove the chosen look</source>
        <translation>Den gewählten Look entfernen</translation>
    </message>
    <message>
        <source>The View as It Is</source>
        <translation>Die Ansicht, wie sie ist</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Look</translation>
    </message>
    <message>
        <source>From a File…</source>
        <translation>Aus einer Datei …</translation>
    </message>
    <message>
        <source>Click: draw the view so. Double click or F2: rename.</source>
        <translation>Klick: Ansicht so zeichnen. Doppelklick oder F2: umbenennen.</translation>
    </message>
    <message>
        <source>A look is a style with a light, a background and outlines of its own, under a name: studio, evening, comic. + adds one.</source>
        <translation>Ein Look ist ein Stil mit eigenem Licht, Hintergrund und Umrissen, unter einem Namen: Studio, Abend, Comic. + fügt einen hinzu.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Save as a File…</source>
        <translation>Als Datei speichern …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take Looks</source>
        <translation>Looks übernehmen</translation>
    </message>
    <message>
        <source>Looks (*%1)</source>
        <translation>Looks (*%1)</translation>
    </message>
    <message>
        <source>Looks taken from %1</source>
        <translation>Looks übernommen aus %1</translation>
    </message>
    <message>
        <source>Save the Look</source>
        <translation>Look speichern</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>%1 cannot be saved: %2</source>
        <translation>%1 kann nicht gespeichert werden: %2</translation>
    </message>
    <message>
        <source>Change a look</source>
        <translation>Look ändern</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Click: draw the view as the scene is lit</source>
        <translation>Klick: Ansicht so zeichnen, wie die Szene beleuchtet ist</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::MarkRecorder</name>
    <message>
        <source>Record “%1”</source>
        <translation>„%1“ aufnehmen</translation>
    </message>
    <message numerus="yes">
        <source>Record %n mark(s)</source>
        <translation>
            <numerusform>%n Zeitmarke aufnehmen</numerusform>
            <numerusform>%n Zeitmarken aufnehmen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::MissingAssetsDialog</name>
    <message>
        <source>Missing Assets</source>
        <translation>Fehlende Dateien</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Was at</source>
        <translation>War in</translation>
    </message>
    <message>
        <source>&amp;Locate…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Bühne</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message numerus="yes">
        <source>%n asset(s) of this scene could not be loaded. The scene is intact and can be saved without loss; what they draw is not shown. When one is found, the others are looked for near it.</source>
        <translation>
            <numerusform>Eine Datei dieser Szene konnte nicht geladen werden. Die Szene ist heil und kann ohne Verlust gespeichert werden; was die Datei zeichnet, fehlt im Bild.</numerusform>
            <numerusform>%n Dateien dieser Szene konnten nicht geladen werden. Die Szene ist heil und kann ohne Verlust gespeichert werden; was die Dateien zeichnen, fehlt im Bild. Ist eine gefunden, werden die anderen in ihrer Nähe gesucht.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::NamesForm</name>
    <message>
        <source>Tags and numbers</source>
        <translation>Marken und Zahlen</translation>
    </message>
    <message>
        <source>Names and colours of tags, and numbers of your own that rules can ask for and change</source>
        <translation>Namen und Farben von Marken und eigene Zahlen, nach denen Regeln fragen und die sie ändern</translation>
    </message>
    <message>
        <source>+ tag</source>
        <translation>+ Marke</translation>
    </message>
    <message>
        <source>Give a tag a name and a colour</source>
        <translation>Einer Marke Namen und Farbe geben</translation>
    </message>
    <message>
        <source>+ number</source>
        <translation>+ Zahl</translation>
    </message>
    <message>
        <source>A number that everybody has, as patience or hunger: rules ask for it</source>
        <translation>Eine Zahl, die jeder hat, etwa Geduld oder Hunger: Regeln fragen danach</translation>
    </message>
    <message>
        <source>Colour of the tag in the picture</source>
        <translation>Farbe der Marke im Bild</translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Forget a tag’s name</source>
        <translation>Namen einer Marke vergessen</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Nobody begins with less</source>
        <translation>Niemand beginnt mit weniger</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Nobody begins with more</source>
        <translation>Niemand beginnt mit mehr</translation>
    </message>
    <message>
        <source>Delete the number</source>
        <translation>Die Zahl löschen</translation>
    </message>
    <message>
        <source>Delete a number</source>
        <translation>Zahl löschen</translation>
    </message>
    <message>
        <source>Change a tag</source>
        <translation>Marke ändern</translation>
    </message>
    <message>
        <source>Change a number</source>
        <translation>Zahl ändern</translation>
    </message>
    <message>
        <source>All 64 tags have names already.</source>
        <translation>Alle 64 Marken haben schon Namen.</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Name a tag</source>
        <translation>Marke benennen</translation>
    </message>
    <message>
        <source>There are %1 numbers already, as many as can be.</source>
        <translation>Es gibt schon %1 Zahlen, mehr sind nicht möglich.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Zahl %1</translation>
    </message>
    <message>
        <source>Add a number</source>
        <translation>Zahl hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>%n kept</source>
        <translation>
            <numerusform>%n behalten</numerusform>
            <numerusform>%n behalten</numerusform>
        </translation>
    </message>
    <message>
        <source>Forget the name; characters keep the tag</source>
        <translation>Namen vergessen; Figuren behalten die Marke</translation>
    </message>
    <message>
        <source>So many characters begin with what Keep Pose has kept; press to let all begin between the two again</source>
        <translation>So viele Figuren beginnen mit dem, was Haltung behalten bewahrt hat; drücken, damit alle wieder zwischen den beiden beginnen</translation>
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
    <name>crowd::widgets::PlacementForm</name>
    <message>
        <source>Who sits in its seats goes with it.</source>
        <translation>Wer auf ihren Sitzen sitzt, kommt mit.</translation>
    </message>
    <message>
        <source>Place stage</source>
        <translation>Bühne versetzen</translation>
    </message>
    <message>
        <source>Change camera</source>
        <translation>Kamera ändern</translation>
    </message>
    <message>
        <source>Stage: %1</source>
        <translation>Bühne: %1</translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation>Kamera: %1</translation>
    </message>
    <message>
        <source>This view</source>
        <translation>Diese Ansicht</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::PresetsDock</name>
    <message>
        <source>Brush presets (*.brush)</source>
        <translation>Pinselvorgaben (*.brush)</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Search names and #tags</source>
        <translation>Namen und #Stichwörter suchen</translation>
    </message>
    <message>
        <source>Keep the brush as it is set now</source>
        <translation>Den Pinsel behalten, wie er jetzt eingestellt ist</translation>
    </message>
    <message>
        <source>Take presets from files</source>
        <translation>Vorgaben aus Dateien übernehmen</translation>
    </message>
    <message>
        <source>Remove the chosen preset</source>
        <translation>Die gewählte Vorgabe entfernen</translation>
    </message>
    <message>
        <source>%1: a click sets it so. F2 gives another name; words with # are tags.</source>
        <translation>%1: Ein Klick stellt ihn so ein. F2 gibt einen anderen Namen; Wörter mit # sind Stichwörter.</translation>
    </message>
    <message>
        <source>Brushes that you set well can be kept here.</source>
        <translation>Gut eingestellte Pinsel können hier behalten werden.</translation>
    </message>
    <message>
        <source>Choose a brush first: presets keep how it is set.</source>
        <translation>Erst einen Pinsel wählen: Vorgaben behalten, wie er eingestellt ist.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Set to the brush of now</source>
        <translation>Auf den Pinsel von jetzt setzen</translation>
    </message>
    <message>
        <source>Save as a file…</source>
        <translation>Als Datei speichern …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take Presets</source>
        <translation>Vorgaben übernehmen</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Vorgabe speichern</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::PropertyLegend</name>
    <message>
        <source>What people are coloured by</source>
        <translation>Wonach Figuren gefärbt sind</translation>
    </message>
    <message>
        <source>Click: select them. Shift+click: select them as well.</source>
        <translation>Klick: diese auswählen. Umschalt+Klick: auch diese auswählen.</translation>
    </message>
    <message>
        <source>Nobody is there yet.</source>
        <translation>Es ist noch niemand da.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RecallForm</name>
    <message>
        <source>Only in this run</source>
        <translation>Nur in diesem Lauf</translation>
    </message>
    <message>
        <source>When one is recalled</source>
        <translation>Beim Abrufen</translation>
    </message>
    <message>
        <source>While it plays the scene stays as it is, and Stop gives it back. The keys always do so.</source>
        <translation>Beim Abspielen bleibt die Szene, wie sie ist, und Anhalten gibt sie zurück. Die Tasten tun das immer.</translation>
    </message>
    <message>
        <source>Only who is selected</source>
        <translation>Nur die Ausgewählten</translation>
    </message>
    <message>
        <source>Others of the state stay as they are, also when keys recall.</source>
        <translation>Die anderen bleiben, wie sie sind, auch wenn mit Tasten abgerufen wird.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RelationsDock</name>
    <message>
        <source>Relations</source>
        <translation>Beziehungen</translation>
    </message>
    <message>
        <source>Show in the picture</source>
        <translation>Im Bild zeigen</translation>
    </message>
    <message>
        <source>Arcs to whom the selected are related; of all where nobody is selected</source>
        <translation>Bögen zu denen, mit denen die Ausgewählten verbunden sind; von allen, wo niemand ausgewählt ist</translation>
    </message>
    <message>
        <source>Add a kind of relation</source>
        <translation>Beziehungsart hinzufügen</translation>
    </message>
    <message>
        <source>Relate each of the selected to each</source>
        <translation>Jeden der Ausgewählten mit jedem verbinden</translation>
    </message>
    <message>
        <source>Take the relation away from the selected</source>
        <translation>Den Ausgewählten die Beziehung nehmen</translation>
    </message>
    <message>
        <source>Select who has such a relation</source>
        <translation>Auswählen, wer eine solche Beziehung hat</translation>
    </message>
    <message>
        <source>Select also who is related so to the selected</source>
        <translation>Auch auswählen, wer mit den Ausgewählten so verbunden ist</translation>
    </message>
    <message>
        <source>Remove the chosen kind with its relations</source>
        <translation>Die gewählte Art mit ihren Beziehungen entfernen</translation>
    </message>
    <message>
        <source>Double click or F2: rename</source>
        <translation>Doppelklick oder F2: umbenennen</translation>
    </message>
    <message numerus="yes">
        <source>%n relations of this kind</source>
        <translation>
            <numerusform>%n Beziehung dieser Art</numerusform>
            <numerusform>%n Beziehungen dieser Art</numerusform>
        </translation>
    </message>
    <message>
        <source>A relation is who belongs to whom. The button above adds a kind.</source>
        <translation>Eine Beziehung sagt, wer zu wem gehört. Der Knopf oben fügt eine Art hinzu.</translation>
    </message>
    <message>
        <source>Nobody is related so yet: drag with the relation brush.</source>
        <translation>Noch ist niemand so verbunden: mit dem Beziehungspinsel ziehen.</translation>
    </message>
    <message>
        <source>Relate Each of the Selected to Each</source>
        <translation>Jeden der Ausgewählten mit jedem verbinden</translation>
    </message>
    <message>
        <source>Take It Away from the Selected</source>
        <translation>Den Ausgewählten nehmen</translation>
    </message>
    <message>
        <source>Select Who Has It</source>
        <translation>Auswählen, wer sie hat</translation>
    </message>
    <message>
        <source>Grow Selection to Those Related So</source>
        <translation>Auswahl auf so Verbundene erweitern</translation>
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
        <source>Paint the chosen relation</source>
        <translation>Die gewählte Beziehung malen</translation>
    </message>
    <message>
        <source>Paint It</source>
        <translation>Malen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RuleCommands</name>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Duplicate the rule</source>
        <translation>Die Regel verdoppeln</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the rule</source>
        <translation>Die Regel löschen</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
    <message>
        <source>Test on Selected</source>
        <translation>An den gewählten ausprobieren</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Test the rule on the selected characters, or on all, while it plays</source>
        <translation>Die Regel an den gewählten Figuren oder an allen ausprobieren, während abgespielt wird</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a rule, or a ready-made set of rules</source>
        <translation>Eine Regel oder fertige Regeln hinzufügen</translation>
    </message>
    <message>
        <source>A New Rule</source>
        <translation>Eine neue Regel</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Change a rule</source>
        <translation>Eine Regel ändern</translation>
    </message>
    <message>
        <source>Reorder the rules</source>
        <translation>Die Regeln umordnen</translation>
    </message>
    <message>
        <source>New rule</source>
        <translation>Neue Regel</translation>
    </message>
    <message>
        <source>Add a rule</source>
        <translation>Eine Regel hinzufügen</translation>
    </message>
    <message>
        <source>Add rules: %1</source>
        <translation>Regeln hinzufügen: %1</translation>
    </message>
    <message>
        <source>Duplicate a rule</source>
        <translation>Eine Regel verdoppeln</translation>
    </message>
    <message>
        <source>Delete a rule</source>
        <translation>Eine Regel löschen</translation>
    </message>
    <message>
        <source>Choose a rule that begins with an event to try it.</source>
        <translation>Zum Ausprobieren eine Regel wählen, die mit einem Ereignis beginnt.</translation>
    </message>
    <message>
        <source>Press Play first: rules act while it plays.</source>
        <translation>Zuerst auf Abspielen drücken: Regeln wirken, während abgespielt wird.</translation>
    </message>
    <message>
        <source>New rule %1</source>
        <translation>Neue Regel %1</translation>
    </message>
    <message numerus="yes">
        <source>Chosen in %n other rule(s) too, where it was still open</source>
        <translation>
            <numerusform>Auch in %n weiteren Regel gewählt, wo noch nichts gewählt war</numerusform>
            <numerusform>Auch in %n weiteren Regeln gewählt, wo noch nichts gewählt war</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RuleEditor</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>+ only if…</source>
        <translation>+ nur wenn …</translation>
    </message>
    <message>
        <source>+ then…</source>
        <translation>+ dann …</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wenn</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>if</source>
        <translation>falls</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation>Diese Bedingung entfernen</translation>
    </message>
    <message>
        <source>do</source>
        <translation>tun</translation>
    </message>
    <message>
        <source>then</source>
        <translation>dann</translation>
    </message>
    <message>
        <source>Remove this</source>
        <translation>Dies entfernen</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>as often as it comes</source>
        <translation>so oft es kommt</translation>
    </message>
    <message>
        <source>Adds a condition</source>
        <translation>Fügt eine Bedingung hinzu</translation>
    </message>
    <message>
        <source>Adds something to do</source>
        <translation>Fügt etwas hinzu, das zu tun ist</translation>
    </message>
    <message>
        <source>either</source>
        <translation>entweder</translation>
    </message>
    <message>
        <source>Earlier, or into or out of what repeats</source>
        <translation>Früher, oder in das Wiederholte hinein oder heraus</translation>
    </message>
    <message>
        <source>Later, or into or out of what repeats</source>
        <translation>Später, oder in das Wiederholte hinein oder heraus</translation>
    </message>
    <message>
        <source>Remove this and what is in it</source>
        <translation>Dies und was darin ist entfernen</translation>
    </message>
    <message>
        <source>+ in it</source>
        <translation>+ darin</translation>
    </message>
    <message>
        <source>Adds something to do in it</source>
        <translation>Fügt darin etwas hinzu</translation>
    </message>
    <message>
        <source>+ or…</source>
        <translation>+ oder …</translation>
    </message>
    <message>
        <source>Adds another one to choose among</source>
        <translation>Fügt ein weiteres zur Wahl hinzu</translation>
    </message>
    <message>
        <source>Before it comes again for the same character</source>
        <translation>Bevor es für dieselbe Figur wieder kommt</translation>
    </message>
    <message>
        <source>So often for the same character</source>
        <translation>So oft für dieselbe Figur</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::RulesDock</name>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>No rules yet. “Add” has ready-made ones to begin with; the event brush (E) sets them off while it plays.</source>
        <translation>Noch keine Regeln. „Hinzufügen“ hat fertige zum Anfangen; der Ereignispinsel (E) löst sie beim Abspielen aus.</translation>
    </message>
    <message>
        <source>What fired, while it plays</source>
        <translation>Beim Abspielen Ausgelöstes</translation>
    </message>
    <message>
        <source>Log only the selected characters</source>
        <translation>Nur Ausgewählte aufschreiben</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
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
        <source>Cameras</source>
        <translation>Kameras</translation>
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
    <message>
        <source>Import Template…</source>
        <translation>Vorlage importieren …</translation>
    </message>
    <message>
        <source>Rename stage</source>
        <translation>Bühne umbenennen</translation>
    </message>
    <message>
        <source>Rename template</source>
        <translation>Vorlage umbenennen</translation>
    </message>
    <message>
        <source>Remove stage</source>
        <translation>Bühne entfernen</translation>
    </message>
    <message>
        <source>Characters</source>
        <translation>Figuren</translation>
    </message>
    <message>
        <source>Select These Characters</source>
        <translation>Diese Figuren auswählen</translation>
    </message>
    <message>
        <source>The look that the view takes on with this camera</source>
        <translation>Der Look, den die Ansicht mit dieser Kamera annimmt</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Look</translation>
    </message>
    <message>
        <source>As It Is Elsewhere</source>
        <translation>Wie sonst auch</translation>
    </message>
    <message>
        <source>Looks are made in the panel Looks</source>
        <translation>Looks entstehen im Bedienfeld Looks</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SelectedFirings</name>
    <message>
        <source>a rule</source>
        <translation>eine Regel</translation>
    </message>
    <message numerus="yes">
        <source>%1, at %2 s, for %n character(s)</source>
        <translation>
            <numerusform>%1, bei %2 s, für eine Figur</numerusform>
            <numerusform>%1, bei %2 s, für %n Figuren</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SessionControl</name>
    <message numerus="yes">
        <source>Keep the pose of %n character(s)</source>
        <translation>
            <numerusform>Die Haltung einer Figur behalten</numerusform>
            <numerusform>Die Haltung von %n Figuren behalten</numerusform>
        </translation>
    </message>
    <message>
        <source>Take it from take &quot;%1&quot;</source>
        <translation>Aus Take „%1“ weiterspielen</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::StatesDock</name>
    <message>
        <source>States</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>Keep how they are now as a new state</source>
        <translation>Wie sie jetzt sind, als neuen Zustand merken</translation>
    </message>
    <message>
        <source>Recall the chosen state</source>
        <translation>Den gewählten Zustand abrufen</translation>
    </message>
    <message>
        <source>Keep how they are now as the chosen state</source>
        <translation>Wie sie jetzt sind, als den gewählten Zustand merken</translation>
    </message>
    <message>
        <source>Remove the chosen state</source>
        <translation>Den gewählten Zustand entfernen</translation>
    </message>
    <message>
        <source>A new state is of</source>
        <translation>Ein neuer Zustand ist von</translation>
    </message>
    <message>
        <source>the whole crowd</source>
        <translation>der ganzen Menge</translation>
    </message>
    <message>
        <source>who is selected</source>
        <translation>den Ausgewählten</translation>
    </message>
    <message>
        <source>Of whom a new state is</source>
        <translation>Von wem ein neuer Zustand ist</translation>
    </message>
    <message>
        <source>and holds</source>
        <translation>und enthält</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Double click or Shift+F%2: recall. F2: rename.</source>
        <translation>%1. Doppelklick oder Umschalt+F%2: abrufen. F2: umbenennen.</translation>
    </message>
    <message>
        <source>%1. Double click: recall. F2: rename.</source>
        <translation>%1. Doppelklick: abrufen. F2: umbenennen.</translation>
    </message>
    <message>
        <source>A state keeps how the crowd is now, and gives it back later: calm, cheering, disappointed. + keeps one.</source>
        <translation>Ein Zustand merkt sich, wie die Menge jetzt ist, und gibt es später zurück: ruhig, jubelnd, enttäuscht. + merkt einen.</translation>
    </message>
    <message>
        <source>Recall</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Keep anew</source>
        <translation>Neu merken</translation>
    </message>
    <message>
        <source>Select its characters</source>
        <translation>Seine Figuren auswählen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Recall only in this run</source>
        <translation>Nur in diesem Lauf abrufen</translation>
    </message>
    <message>
        <source>Outline in the picture who differs from the chosen state</source>
        <translation>Im Bild umranden, wer vom gewählten Zustand abweicht</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Different: %1</source>
        <translation>Anders: %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>group “%1”</source>
        <translation>Gruppe „%1“</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Nobody whom it keeps is there any more.</source>
        <translation>Niemand, den er sich merkt, ist noch da.</translation>
    </message>
    <message>
        <source>They are like that now.</source>
        <translation>So sind sie jetzt.</translation>
    </message>
    <message>
        <source>Of %1 out of %2 characters. %3</source>
        <translation>Von %1 der %2 Figuren. %3</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::StrokesDock</name>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Draw everything random about this stroke anew</source>
        <translation>Alles Zufällige an diesem Strich neu ziehen</translation>
    </message>
    <message>
        <source>Lay this stroke with the brush as it is set now</source>
        <translation>Diesen Strich mit dem Pinsel legen, wie er jetzt eingestellt ist</translation>
    </message>
    <message>
        <source>Set the brush as it is set for this stroke</source>
        <translation>Den Pinsel einstellen wie für diesen Strich</translation>
    </message>
    <message>
        <source>%1: nobody now</source>
        <translation>%1: jetzt niemand</translation>
    </message>
    <message>
        <source>The last strokes are listed here. Their settings can be changed until something else is edited.</source>
        <translation>Hier stehen die letzten Striche. Ihre Einstellungen lassen sich ändern, bis etwas anderes bearbeitet wird.</translation>
    </message>
    <message>
        <source>Laid anew: %1</source>
        <translation>Neu gelegt: %1</translation>
    </message>
    <message>
        <source>Whom this met depends on more than the scene: it was playing, clips were still being loaded, or people got back what they had. They stay the ones it met, until its area is changed.</source>
        <translation>Wen dies traf, hängt von mehr als der Szene ab: Sie lief gerade, Clips wurden noch geladen, oder Figuren bekamen zurück, was sie hatten. Es bleiben die, die es traf, bis sein Bereich geändert wird.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::SurfaceForm</name>
    <message>
        <source>Body radius, m</source>
        <translation>Körperradius, m</translation>
    </message>
    <message>
        <source>Body height, m</source>
        <translation>Körpergröße, m</translation>
    </message>
    <message>
        <source>Lower places are not walked under</source>
        <translation>Unter Niedrigerem gehen sie nicht hindurch</translation>
    </message>
    <message>
        <source>Highest step, m</source>
        <translation>Höchste Stufe, m</translation>
    </message>
    <message>
        <source>Steepest slope, °</source>
        <translation>Steilste Neigung, °</translation>
    </message>
    <message>
        <source>Being found: %1 %</source>
        <translation>Wird gesucht: %1 %</translation>
    </message>
    <message numerus="yes">
        <source>Found: %n areas</source>
        <translation>
            <numerusform>Gefunden: eine Fläche</numerusform>
            <numerusform>Gefunden: %n Flächen</numerusform>
        </translation>
    </message>
    <message>
        <source>Open ground. It is looked at once somebody walks among a stage, obstacles or painted ground.</source>
        <translation>Freies Gelände. Es wird untersucht, sobald jemand zwischen Bühne, Hindernissen oder bemaltem Boden geht.</translation>
    </message>
    <message>
        <source>Where characters can walk</source>
        <translation>Wo Figuren gehen können</translation>
    </message>
    <message>
        <source>So far characters keep from walls</source>
        <translation>So viel Abstand halten Figuren von Wänden</translation>
    </message>
    <message>
        <source>Change where characters can walk</source>
        <translation>Gehfläche ändern</translation>
    </message>
    <message>
        <source>Show on the ground</source>
        <translation>Auf dem Boden zeigen</translation>
    </message>
    <message>
        <source>Colours the ground of the stages where characters can walk</source>
        <translation>Färbt den Boden der Bühnen, wo Figuren gehen können</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakeFigures</name>
    <message>
        <source>The whole takes are being compared: %1 %</source>
        <translation>Die ganzen Takes werden verglichen: %1 %</translation>
    </message>
    <message>
        <source>In the whole take everybody is as in &quot;%1&quot;.</source>
        <translation>Im ganzen Take ist jede Figur wie in „%1“.</translation>
    </message>
    <message>
        <source>In the whole take %1 of %2 are elsewhere than in &quot;%3&quot; at some time: from %4 on, %5 m at most, at %6.</source>
        <translation>Im ganzen Take sind irgendwann %1 von %2 anderswo als in „%3“: ab %4, höchstens %5 m, bei %6.</translation>
    </message>
    <message numerus="yes">
        <source>Up to %n character(s) are there in one of them only.</source>
        <translation>
            <numerusform>Bis zu %n Figur ist nur in einem von beiden da.</numerusform>
            <numerusform>Bis zu %n Figuren sind nur in einem von beiden da.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakeShelf</name>
    <message>
        <source>Take %1</source>
        <translation>Take %1</translation>
    </message>
    <message>
        <source>Keep take &quot;%1&quot;</source>
        <translation>Take „%1“ behalten</translation>
    </message>
    <message numerus="yes">
        <source>Retake %n character(s)</source>
        <translation>
            <numerusform>%n Figur neu spielen</numerusform>
            <numerusform>%n Figuren neu spielen</numerusform>
        </translation>
    </message>
    <message>
        <source>There are as many takes as there can be. Delete some first.</source>
        <translation>Es gibt so viele Takes, wie es geben kann. Löschen Sie zuerst einige.</translation>
    </message>
    <message>
        <source>Show take &quot;%1&quot;</source>
        <translation>Take „%1“ zeigen</translation>
    </message>
    <message>
        <source>Play the scene instead of a take</source>
        <translation>Die Szene statt eines Takes spielen</translation>
    </message>
    <message>
        <source>Delete take &quot;%1&quot;</source>
        <translation>Take „%1“ löschen</translation>
    </message>
    <message>
        <source>Rename take to &quot;%1&quot;</source>
        <translation>Take in „%1“ umbenennen</translation>
    </message>
    <message>
        <source>Another take is called &quot;%1&quot; already.</source>
        <translation>Ein anderer Take heißt schon „%1“.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TakesDock</name>
    <message>
        <source>Takes</source>
        <translation>Takes</translation>
    </message>
    <message>
        <source>Keep what has been played as a take</source>
        <translation>Das Gespielte als Take behalten</translation>
    </message>
    <message>
        <source>Show the chosen one</source>
        <translation>Den gewählten zeigen</translation>
    </message>
    <message>
        <source>See the chosen take as ghosts beside what is shown, with how far apart everybody is</source>
        <translation>Den gewählten Take als Geister neben dem Gezeigten sehen, und wie weit alle auseinander sind</translation>
    </message>
    <message>
        <source>Take the selected characters again, in the play range or else from the moment shown on: everybody else does what he did</source>
        <translation>Die gewählten Figuren neu spielen lassen, im Abspielbereich, sonst vom gezeigten Augenblick an: Alle anderen tun, was sie taten</translation>
    </message>
    <message>
        <source>Delete the chosen take</source>
        <translation>Den gewählten Take löschen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is kept.</source>
        <translation>„%1“ ist behalten.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message numerus="yes">
        <source>%n character(s)</source>
        <translation>
            <numerusform>%n Figur</numerusform>
            <numerusform>%n Figuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2. Enter shows it, F2 renames it.</source>
        <translation>%1, %2. Eingabe zeigt ihn, F2 benennt ihn um.</translation>
    </message>
    <message>
        <source>The scene as it plays</source>
        <translation>Die Szene, wie sie spielt</translation>
    </message>
    <message>
        <source>Enter shows it.</source>
        <translation>Eingabe zeigt sie.</translation>
    </message>
    <message>
        <source>The take is being kept: %1 %</source>
        <translation>Der Take wird behalten: %1 %</translation>
    </message>
    <message>
        <source>Play, then keep what was played. A take can be seen again whatever becomes of paths, rules and marks.</source>
        <translation>Spielen Sie ab und behalten Sie dann das Gespielte. Einen Take kann man wieder sehen, was immer aus Pfaden, Regeln und Zeitmarken wird.</translation>
    </message>
    <message>
        <source>People move as in the take: what they are told and where they are to go counts for the scene as it plays.</source>
        <translation>Alle bewegen sich wie im Take: Was man ihnen sagt und wohin sie gehen sollen, gilt für die Szene, wie sie spielt.</translation>
    </message>
    <message>
        <source>At %1 everybody is as in &quot;%2&quot;.</source>
        <translation>Bei %1 sind alle wie in „%2“.</translation>
    </message>
    <message>
        <source>At %1, %2 of %3 are elsewhere than in &quot;%4&quot;: %5 m on average, %6 m at most.</source>
        <translation>Bei %1 sind %2 von %3 anderswo als in „%4“: %5 m im Mittel, höchstens %6 m.</translation>
    </message>
    <message numerus="yes">
        <source>%n character(s) taken again: &quot;%1&quot;.</source>
        <translation>
            <numerusform>%n Figur hat neu gespielt: „%1“.</numerusform>
            <numerusform>%n Figuren haben neu gespielt: „%1“.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the end somebody is brought back over %1 m: choose a longer stretch.</source>
        <translation>Am Ende wird jemand über %1 m zurückgebracht: Wählen Sie einen längeren Zeitraum.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Hide Ghosts</source>
        <translation>Geister ausblenden</translation>
    </message>
    <message>
        <source>See as Ghosts</source>
        <translation>Als Geister sehen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Play on from the moment shown, as a run that can be told what to do; the take stays as it is</source>
        <translation>Vom gezeigten Augenblick an weiterspielen, als Lauf, dem man etwas sagen kann; der Take bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Nobody walks or follows rules here: there is nothing to keep yet.</source>
        <translation>Hier geht niemand und niemand folgt Regeln: es gibt noch nichts zu behalten.</translation>
    </message>
    <message numerus="yes">
        <source>%n character(s) are there in one of them only.</source>
        <translation>
            <numerusform>%n Figur ist nur in einem von beiden da.</numerusform>
            <numerusform>%n Figuren sind nur in einem von beiden da.</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;%1&quot; is kept. It begins at %2 s, where the run did.</source>
        <translation>„%1“ ist behalten. Er beginnt bei %2 s, wo der Lauf begann.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplateDelegate</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplatePreview</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
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
    <message>
        <source>Ticked templates are painted by the create brush; a double click paints one alone</source>
        <translation>Angekreuzte Vorlagen malt der Pinsel zum Erschaffen; ein Doppelklick malt nur eine</translation>
    </message>
    <message>
        <source>How often the chosen template comes in the mix</source>
        <translation>Wie oft die gewählte Vorlage in der Mischung vorkommt</translation>
    </message>
    <message>
        <source>Rename template</source>
        <translation>Vorlage umbenennen</translation>
    </message>
    <message>
        <source>Add from the library of built-in characters</source>
        <translation>Aus der Bibliothek mitgelieferter Figuren hinzufügen</translation>
    </message>
    <message>
        <source>Import templates from files</source>
        <translation>Vorlagen aus Dateien importieren</translation>
    </message>
    <message>
        <source>Add from Library…</source>
        <translation>Aus Bibliothek hinzufügen …</translation>
    </message>
    <message>
        <source>Import Templates…</source>
        <translation>Vorlagen importieren …</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>Clips …</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TimelineDock</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Record: cues, states and events become marks of the timeline as they are performed while it plays</source>
        <translation>Aufnehmen: Stichwörter, Zustände und Ereignisse werden zu Zeitmarken, wenn sie gegeben werden, während es läuft</translation>
    </message>
    <message>
        <source>The mark before this moment</source>
        <translation>Die Zeitmarke vor diesem Augenblick</translation>
    </message>
    <message>
        <source>The mark after this moment</source>
        <translation>Die Zeitmarke nach diesem Augenblick</translation>
    </message>
    <message>
        <source>A marker at this moment</source>
        <translation>Ein Merkpunkt für diesen Augenblick</translation>
    </message>
    <message>
        <source>Remove the chosen marks</source>
        <translation>Die gewählten Zeitmarken entfernen</translation>
    </message>
    <message>
        <source>Show all marks, and all that has been played</source>
        <translation>Alle Zeitmarken zeigen, und alles, was gespielt worden ist</translation>
    </message>
    <message>
        <source>What times are shown in, and caught by when marks are dragged</source>
        <translation>Worin Zeiten gezeigt werden, und worauf gezogene Zeitmarken einrasten</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>Choose a mark to see what happens there.</source>
        <translation>Wählen Sie eine Zeitmarke, um zu sehen, was dort geschieht.</translation>
    </message>
    <message numerus="yes">
        <source>%n marks are chosen: drag them, or remove them.</source>
        <translation>
            <numerusform>%n Zeitmarke ist gewählt: ziehen oder entfernen Sie sie.</numerusform>
            <numerusform>%n Zeitmarken sind gewählt: ziehen oder entfernen Sie sie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n characters, as it was recorded.</source>
        <translation>
            <numerusform>Für %n Figur, wie es aufgenommen wurde.</numerusform>
            <numerusform>Für %n Figuren, wie es aufgenommen wurde.</numerusform>
        </translation>
    </message>
    <message>
        <source>Change a mark</source>
        <translation>Zeitmarke ändern</translation>
    </message>
    <message>
        <source>What is played begins at this moment</source>
        <translation>Was abgespielt wird, beginnt in diesem Augenblick</translation>
    </message>
    <message>
        <source>What is played ends at this moment</source>
        <translation>Was abgespielt wird, endet in diesem Augenblick</translation>
    </message>
    <message>
        <source>Play over and over</source>
        <translation>Immer wieder abspielen</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und eine weitere.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
    <message>
        <source>From this moment on the camera looks as the view does now</source>
        <translation>Von diesem Augenblick an sieht die Kamera, was die Ansicht jetzt zeigt</translation>
    </message>
    <message>
        <source>The view looks through the timeline&apos;s camera, where there is one</source>
        <translation>Die Ansicht blickt durch die Kamera der Zeitleiste, wo es eine gibt</translation>
    </message>
    <message>
        <source>Drag the side away, or back from the edge</source>
        <translation>Ziehen Sie die Seite weg oder vom Rand zurück</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::TimelineView</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, at %2 s</source>
        <translation>%1, bei %2 s</translation>
    </message>
    <message>
        <source>Show This Moment</source>
        <translation>Diesen Augenblick zeigen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Drag to see what has been played; with Shift held, what is to be played</source>
        <translation>Ziehen zeigt, was abgespielt wurde; mit Umschalt wird gewählt, was abgespielt wird</translation>
    </message>
    <message>
        <source>Play from Here On</source>
        <translation>Ab hier abspielen</translation>
    </message>
    <message>
        <source>Play until Here</source>
        <translation>Bis hier abspielen</translation>
    </message>
    <message>
        <source>Play All Time</source>
        <translation>Die ganze Zeit abspielen</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) copied: Ctrl+V puts them where the moment shown is</source>
        <translation>
            <numerusform>%n Zeitmarke kopiert: Strg+V setzt sie an den gezeigten Augenblick</numerusform>
            <numerusform>%n Zeitmarken kopiert: Strg+V setzt sie an den gezeigten Augenblick</numerusform>
        </translation>
    </message>
    <message>
        <source>The marks that were copied are not there any more.</source>
        <translation>Die kopierten Zeitmarken gibt es nicht mehr.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ToolController</name>
    <message>
        <source>Brush size: %1 px</source>
        <translation>Pinselgröße: %1 px</translation>
    </message>
    <message>
        <source>There is no ground under the cursor</source>
        <translation>Unter dem Mauszeiger ist kein Boden</translation>
    </message>
    <message>
        <source>Click a point in the picture</source>
        <translation>Einen Punkt im Bild anklicken</translation>
    </message>
    <message>
        <source>There is nobody under the cursor</source>
        <translation>Unter dem Mauszeiger ist niemand</translation>
    </message>
    <message>
        <source>Click somebody in the picture</source>
        <translation>Jemanden im Bild anklicken</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ValueSlider</name>
    <message>
        <source>“%1” is no number: the value stays as it was.</source>
        <translation>„%1“ ist keine Zahl: Der Wert bleibt, wie er war.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::ViewportOverlay</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch eine</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
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
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Take it back (Esc)</source>
        <translation>Zurücknehmen (Esc)</translation>
    </message>
    <message>
        <source>Nobody is here yet.
Drag over the ground: characters come.</source>
        <translation>Hier ist noch niemand.
Über den Boden ziehen: Figuren kommen.</translation>
    </message>
    <message>
        <source>Nobody is here yet.
Press C and paint characters on the ground.</source>
        <translation>Hier ist noch niemand.
C drücken und Figuren auf den Boden malen.</translation>
    </message>
    <message>
        <source>Finding out where characters can walk</source>
        <translation>Herausfinden, wo man gehen kann</translation>
    </message>
    <message>
        <source>Playing up to this moment once more</source>
        <translation>Spielt bis zu diesem Augenblick noch einmal</translation>
    </message>
    <message>
        <source>Animations are not prepared: some characters stand still.</source>
        <translation>Animationen sind nicht vorbereitet: manche Figuren stehen still.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Go on preparing them</source>
        <translation>Sie weiter vorbereiten</translation>
    </message>
    <message>
        <source>Preparing animations: %1 of %2</source>
        <translation>Animationen werden vorbereitet: %1 von %2</translation>
    </message>
    <message>
        <source>Stop: whose animation is not ready stands still</source>
        <translation>Anhalten: wessen Animation nicht fertig ist, steht still</translation>
    </message>
    <message>
        <source>The memory for prepared animations is used up: some characters stand still. The preferences set its size.</source>
        <translation>Der Speicher für vorbereitete Animationen ist voll: manche Figuren stehen still. Die Einstellungen setzen seine Größe.</translation>
    </message>
    <message>
        <source>The memory of the graphics card is used up: characters and pictures are coarser. Fewer templates, or other programs closed, make room.</source>
        <translation>Der Speicher der Grafikkarte ist voll: Figuren und Bilder sind gröber. Weniger Vorlagen oder geschlossene andere Programme schaffen Platz.</translation>
    </message>
</context>
<context>
    <name>crowd::widgets::WelcomePage</name>
    <message>
        <source>Theatre</source>
        <translation>Theater</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Stadt</translation>
    </message>
    <message>
        <source>Stadium</source>
        <translation>Stadion</translation>
    </message>
    <message>
        <source>Meadow</source>
        <translation>Wiese</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Paint a crowd</source>
        <translation>Eine Menge malen</translation>
    </message>
    <message>
        <source>&amp;Show this page at start</source>
        <translation>Diese Seite beim &amp;Start zeigen</translation>
    </message>
    <message>
        <source>Ready-made scenes</source>
        <translation>Fertige Szenen</translation>
    </message>
    <message>
        <source>Open “%1” as a new scene</source>
        <translation>„%1“ als neue Szene öffnen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>New Empty &amp;Theatre</source>
        <translation>Neues leeres &amp;Theater</translation>
    </message>
    <message>
        <source>New Empty &amp;Ground</source>
        <translation>Neuer leerer &amp;Boden</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>No scenes yet</source>
        <translation>Noch keine Szenen</translation>
    </message>
    <message>
        <source>Choose whom to paint with in the scene behind this page</source>
        <translation>Wählen, wer in der Szene hinter dieser Seite gemalt wird</translation>
    </message>
    <message>
        <source>Character &amp;Library…</source>
        <translation>Figuren&amp;bibliothek …</translation>
    </message>
</context>
</TS>
