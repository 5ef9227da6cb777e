// SPDX-License-Identifier: MIT
#include "app/window/FindWords.h"

#include <algorithm>
#include <iterator>

#include <QtCore/QCoreApplication>

namespace crowd::app {

namespace {

struct FindWordsOf
{
    const char* id;
    const char* words; ///< translators write what people of their language look for
};

constexpr FindWordsOf kWords[] = {
    {"brush-create", QT_TRANSLATE_NOOP("FindWords", "people spray add place populate audience")},
    {"brush-delete", QT_TRANSLATE_NOOP("FindWords", "erase eraser rubber remove people")},
    {"brush-colour", QT_TRANSLATE_NOOP("FindWords", "color dye clothes tint paint")},
    {"brush-outfit", QT_TRANSLATE_NOOP("FindWords", "clothes dress costume uniform fans team")},
    {"brush-material", QT_TRANSLATE_NOOP("FindWords", "skin hair cloth texture variant")},
    {"brush-parts", QT_TRANSLATE_NOOP("FindWords", "hat bag props accessories")},
    {"brush-animation", QT_TRANSLATE_NOOP("FindWords", "dance clap wave cheer motion pose move")},
    {"brush-style", QT_TRANSLATE_NOOP("FindWords", "gait speed run stroll")},
    {"brush-time", QT_TRANSLATE_NOOP("FindWords", "offset phase synchronous delay wave")},
    {"brush-orientation", QT_TRANSLATE_NOOP("FindWords", "turn rotate look face direction")},
    {"brush-scale", QT_TRANSLATE_NOOP("FindWords", "size tall small fat thin")},
    {"brush-feature", QT_TRANSLATE_NOOP("FindWords", "mood emotion happy sad attribute")},
    {"brush-event", QT_TRANSLATE_NOOP("FindWords", "trigger message signal")},
    {"brush-walk", QT_TRANSLATE_NOOP("FindWords", "go target destination send")},
    {"brush-path", QT_TRANSLATE_NOOP("FindWords", "route way road line street parade queue")},
    {"brush-environment",
     QT_TRANSLATE_NOOP("FindWords", "wall fence barrier obstacle exit entrance door area zone")},
    {"brush-push", QT_TRANSLATE_NOOP("FindWords", "shove spread move comb")},
    {"brush-relation", QT_TRANSLATE_NOOP("FindWords", "family friends couple pair link")},
    {"brush-group", QT_TRANSLATE_NOOP("FindWords", "family team layer flock")},
    {"brush-restore", QT_TRANSLATE_NOOP("FindWords", "undo original back reset former")},
    {"brush-shuffle", QT_TRANSLATE_NOOP("FindWords", "mix swap random")},
    {"brush-smooth", QT_TRANSLATE_NOOP("FindWords", "blur even average")},
    {"brush-clone", QT_TRANSLATE_NOOP("FindWords", "copy stamp duplicate")},
    {"brush-template", QT_TRANSLATE_NOOP("FindWords", "replace character model exchange")},
    {"brush-tag", QT_TRANSLATE_NOOP("FindWords", "label mark keyword")},
    {"select", QT_TRANSLATE_NOOP("FindWords", "arrow pointer choose pick move")},
    {"library", QT_TRANSLATE_NOOP("FindWords", "characters people models stages assets")},
    {"import-template",
     QT_TRANSLATE_NOOP("FindWords", "character model figure glTF GLB Mixamo Blender load")},
    {"import-stage",
     QT_TRANSLATE_NOOP("FindWords", "set building scenery model glTF GLB background load")},
    {"save-picture",
     QT_TRANSLATE_NOOP("FindWords", "render export screenshot image PNG EXR still")},
    {"make-movie", QT_TRANSLATE_NOOP("FindWords", "render export video film MP4 GIF animation")},
    {"camera-add", QT_TRANSLATE_NOOP("FindWords", "bookmark viewpoint shot")},
    {"camera-mark", QT_TRANSLATE_NOOP("FindWords", "keyframe key flight move shot")},
    {"duplicate", QT_TRANSLATE_NOOP("FindWords", "copy paste clone")},
    {"undo", QT_TRANSLATE_NOOP("FindWords", "back revert mistake")},
    {"preferences", QT_TRANSLATE_NOOP("FindWords", "settings options language memory tablet")},
    {"play-loop", QT_TRANSLATE_NOOP("FindWords", "loop repeat cycle")},
    {"keep-pose", QT_TRANSLATE_NOOP("FindWords", "freeze bake position stop")},
    {"put-on-ground", QT_TRANSLATE_NOOP("FindWords", "drop floor snap height")},
    {"walkable", QT_TRANSLATE_NOOP("FindWords", "navmesh navigation mesh floor")},
    {"hide-panels", QT_TRANSLATE_NOOP("FindWords", "canvas docks interface hide")},
    {"panel-light", QT_TRANSLATE_NOOP("FindWords", "lamp sun sky night day shadow fog spotlight")},
    {"panel-looks", QT_TRANSLATE_NOOP("FindWords", "style cartoon clay background tone comic")},
    {"panel-environment",
     QT_TRANSLATE_NOOP("FindWords", "wall fence obstacle exit entrance door area zone places")},
    {"panel-rules", QT_TRANSLATE_NOOP("FindWords", "behaviour behavior trigger condition if cue")},
    {"panel-states", QT_TRANSLATE_NOOP("FindWords", "snapshot pose version mood")},
    {"panel-timeline", QT_TRANSLATE_NOOP("FindWords", "keyframe animation marker schedule")},
    {"panel-takes", QT_TRANSLATE_NOOP("FindWords", "recording cache simulation bake")},
    {"panel-history", QT_TRANSLATE_NOOP("FindWords", "undo back steps")},
    {"panel-strokes", QT_TRANSLATE_NOOP("FindWords", "layers edit later stack")},
    {"panel-presets", QT_TRANSLATE_NOOP("FindWords", "favourites favorites saved brushes")},
    {"panel-individual", QT_TRANSLATE_NOOP("FindWords", "selected person inspector properties")},
    {"panel-scene", QT_TRANSLATE_NOOP("FindWords", "outliner stages characters files missing")},
    {"panel-templates", QT_TRANSLATE_NOOP("FindWords", "characters models mix weights people")},
    {"panel-colour", QT_TRANSLATE_NOOP("FindWords", "color palette swatches dropper wheel")},
    {"panel-features", QT_TRANSLATE_NOOP("FindWords", "mood emotion attributes")},
    {"panel-relations", QT_TRANSLATE_NOOP("FindWords", "family friends links network")},
    {"panel-groups", QT_TRANSLATE_NOOP("FindWords", "layers families teams visibility hide lock")},
    {"panel-console", QT_TRANSLATE_NOOP("FindWords", "script code programming")},
};

} // namespace

QString findWords(const QString& id)
{
    const auto* const found = std::ranges::find_if(
        kWords, [&id](const FindWordsOf& each) { return id == QLatin1String(each.id); });
    return found == std::end(kWords) ? QString()
                                     : QCoreApplication::translate("FindWords", found->words);
}

std::vector<QString> idsWithFindWords()
{
    std::vector<QString> ids;
    ids.reserve(std::size(kWords));
    for (const FindWordsOf& each : kWords) {
        ids.push_back(QLatin1String(each.id));
    }
    return ids;
}

} // namespace crowd::app
