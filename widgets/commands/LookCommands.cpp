// SPDX-License-Identifier: MIT
#include "widgets/commands/LookCommands.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>

#include "model/document/SceneEdit.h"
#include "model/project/LookFile.h"
#include "widgets/state/ShownLook.h"

namespace crowd::widgets {

using model::LookId;
using model::LookPreset;
using model::Looks;

namespace {

struct LookText
{
    Q_DECLARE_TR_FUNCTIONS(LookCommands)
};

LookPreset named(const char* name, model::LookStyle style, model::LookLight light)
{
    LookPreset look;
    look.name = name;
    look.style = style;
    look.light = light;
    return look;
}

std::vector<LookPreset> madeReady()
{
    using model::LookLight;
    using model::LookStyle;
    LookPreset studio =
        named(QT_TRANSLATE_NOOP("Looks", "Studio"), LookStyle::Lit, LookLight::Studio);
    studio.hasLamps = false;
    const LookPreset evening =
        named(QT_TRANSLATE_NOOP("Looks", "Evening"), LookStyle::Lit, LookLight::Dusk);
    const LookPreset spots =
        named(QT_TRANSLATE_NOOP("Looks", "Spotlights"), LookStyle::Lit, LookLight::Night);
    LookPreset comic =
        named(QT_TRANSLATE_NOOP("Looks", "Comic"), LookStyle::Cartoon, LookLight::Noon);
    comic.hasOutline = true;
    comic.outlinePixels = 3.0F;
    LookPreset shapes =
        named(QT_TRANSLATE_NOOP("Looks", "Silhouettes"), LookStyle::Silhouettes, LookLight::Scene);
    shapes.hasBackground = true;
    shapes.background = {255, 255, 255};
    return {studio, evening, spots, comic, shapes};
}

bool isTaken(const Looks& looks, const std::string& name)
{
    return model::findLook(looks, name) != nullptr;
}

std::string freeLookName(const Looks& looks, const QString& like)
{
    QString name = like;
    for (int number = 2; isTaken(looks, name.toStdString()); ++number) {
        name = like + QLatin1Char(' ') + QString::number(number);
    }
    return name.toStdString();
}

model::EditOutcome putLooks(EditorState& state, const QString& undoText, Looks looks)
{
    return state.document().edit(
        undoText, [&looks](model::SceneEdit& edit) { edit.setLooks(std::move(looks)); });
}

} // namespace

std::span<const LookPreset> readyLooks()
{
    static const std::vector<LookPreset> kReady = madeReady();
    return kReady;
}

LookPreset lookOfView(const EditorState& state)
{
    const ViewOptions& options = state.viewOptions();
    const LookPreset* shown = shownLook(state);
    LookPreset look = shown != nullptr ? *shown : LookPreset();
    look.style = static_cast<model::LookStyle>(options.look);
    look.property = options.property;
    look.hasShadows = options.showShadows;
    return look;
}

LookId addLook(EditorState& state, LookPreset look, const QString& name)
{
    Looks looks = state.scene().looks;
    look.id = state.scene().freeLookId();
    if (look.id == 0) {
        state.showStatus(
            LookText::tr("A scene has at most %1 looks: remove one first.").arg(model::kMostLooks));
        return 0;
    }
    look.name = freeLookName(looks, name);
    const LookId id = look.id;
    looks.push_back(std::move(look));
    if (putLooks(state, LookText::tr("Add a look"), std::move(looks)) ==
        model::EditOutcome::Refused) {
        return 0;
    }
    showLook(state, id);
    return id;
}

void removeLook(EditorState& state, LookId id)
{
    Looks looks = state.scene().looks;
    std::erase_if(looks, [id](const LookPreset& each) { return each.id == id; });
    (void)putLooks(state, LookText::tr("Remove a look"), std::move(looks));
}

bool renameLook(EditorState& state, LookId id, const QString& name)
{
    const Looks& looks = state.scene().looks;
    const std::string text = name.simplified().toStdString();
    const LookPreset* same = model::findLook(looks, text);
    if (text.empty() || (same != nullptr && same->id != id)) {
        state.showStatus(text.empty() ? LookText::tr("A look needs a name.")
                                      : LookText::tr("There is a look “%1” already.").arg(name));
        return false;
    }
    (void)putLooks(state, LookText::tr("Rename a look"),
                   withLook(looks, id, [&text](LookPreset& each) { each.name = text; }));
    return true;
}

void moveLook(EditorState& state, LookId id, int by)
{
    Looks looks = state.scene().looks;
    const auto found = std::ranges::find(looks, id, &LookPreset::id);
    const auto to = found - looks.begin() + by;
    if (found == looks.end() || to < 0 || to >= std::ssize(looks)) {
        return;
    }
    LookPreset moved = std::move(*found);
    looks.erase(found);
    looks.insert(looks.begin() + to, std::move(moved));
    (void)putLooks(state, LookText::tr("Move a look"), std::move(looks));
}

Looks withLook(const Looks& looks, LookId id, const std::function<void(LookPreset&)>& apply)
{
    Looks changed = looks;
    for (LookPreset& each : changed) {
        if (each.id == id) {
            apply(each);
        }
    }
    return changed;
}

model::Result<void> exportLook(const EditorState& state, LookId id, const QString& path)
{
    const LookPreset* found = model::findLook(state.scene().looks, id);
    return found != nullptr ? model::writeLookFile({*found}, path) : model::Result<void>();
}

model::Result<void> importLooks(EditorState& state, const QString& path)
{
    const auto read = model::readLookFile(path);
    if (!read) {
        return read.error();
    }
    auto all = model::withLooks(state.scene(), read.value());
    if (!all) {
        return all.error();
    }
    (void)putLooks(state, LookText::tr("Take looks"), std::move(all).value());
    return {};
}

} // namespace crowd::widgets
