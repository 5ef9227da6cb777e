// SPDX-License-Identifier: MIT
#include "app/window/BrushMemory.h"

#include <vector>

#include <nlohmann/json.hpp>

#include <QtCore/QSettings>

#include "model/describe/FieldChecks.h"
#include "model/describe/FieldJson.h"
#include "widgets/state/ToolId.h"

namespace crowd::app {

namespace {

using model::BrushSettings;
using model::FieldInfo;

constexpr int kSaveMs = 1000;

QString keyOf(const widgets::ToolInfo& tool)
{
    return QStringLiteral("brushes/") + QLatin1String(tool.stableId);
}

/// What the next start knows of a list of fields: not what is the scene's.
std::vector<FieldInfo> rememberedOf(std::span<const FieldInfo> fields)
{
    std::vector<FieldInfo> kept;
    for (const FieldInfo& field : fields) {
        if (field.meta.isRemembered) {
            kept.push_back(field);
        }
    }
    return kept;
}

QByteArray textOf(const BrushSettings& brush)
{
    const model::BrushType& type = model::brushType(brush.kind());
    nlohmann::json json = nlohmann::json::object();
    model::addFields(json, rememberedOf(model::fieldsOf<BrushSettings>()), &brush);
    model::addFields(json, rememberedOf(type.fields), type.settings(brush));
    return QByteArray::fromStdString(json.dump());
}

/// What is not in the text, or wrong, stays as it is.
BrushSettings withText(BrushSettings brush, const QByteArray& text)
{
    const auto json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    if (!json.is_object()) {
        return brush;
    }
    const model::BrushType& type = model::brushType(brush.kind());
    model::Message problem;
    model::JsonFields fields(json, {}, problem);
    const auto read = [&fields](const std::vector<FieldInfo>& remembered, void* object) {
        model::readFields(fields, remembered, object, model::WrongValue::Keep);
    };
    BrushSettings known = brush;
    read(rememberedOf(model::fieldsOf<BrushSettings>()), &known);
    read(rememberedOf(type.fields), type.editable(known));
    const bool isSound = model::checkFields(model::fieldsOf<BrushSettings>(), &known, {}) &&
                         model::checkFields(type.fields, type.settings(known), {});
    return isSound ? known : brush;
}

} // namespace

BrushMemory::BrushMemory(widgets::EditorState& state, QObject* parent)
    : QObject(parent), m_state(state)
{
    restore();
    m_later.setSingleShot(true);
    m_later.setInterval(kSaveMs);
    connect(&m_later, &QTimer::timeout, this, &BrushMemory::save);
    connect(&state, &widgets::EditorState::brushChanged, this, [this] { m_later.start(); });
}

void BrushMemory::restore()
{
    const QSettings settings;
    for (const widgets::ToolInfo& tool : widgets::toolTable()) {
        const QByteArray text = settings.value(keyOf(tool)).toByteArray();
        if (tool.brush && !text.isEmpty()) {
            m_state.setBrush(withText(m_state.brush(*tool.brush), text));
        }
    }
}

void BrushMemory::save() const
{
    QSettings settings;
    for (const widgets::ToolInfo& tool : widgets::toolTable()) {
        if (tool.brush) {
            settings.setValue(keyOf(tool), textOf(m_state.brush(*tool.brush)));
        }
    }
}

void BrushMemory::reset()
{
    for (const widgets::ToolInfo& tool : widgets::toolTable()) {
        if (tool.brush) {
            const BrushSettings fresh = model::initialBrush(*tool.brush);
            m_state.setBrush(withText(m_state.brush(*tool.brush), textOf(fresh)));
        }
    }
}

} // namespace crowd::app
