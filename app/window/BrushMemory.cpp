// SPDX-License-Identifier: MIT
#include "app/window/BrushMemory.h"

#include <utility>

#include <nlohmann/json.hpp>

#include <QtCore/QSettings>

#include "model/brush/BrushJson.h"
#include "widgets/state/ToolId.h"

namespace crowd::app {

namespace {

using model::BrushSettings;

constexpr int kSaveMs = 1000;

QString keyOf(const widgets::ToolInfo& tool)
{
    return QStringLiteral("brushes/") + QLatin1String(tool.stableId);
}

QByteArray textOf(const BrushSettings& brush)
{
    return QByteArray::fromStdString(brushJson(brush, model::BrushFields::Remembered).dump());
}

/// What is not in the text, or wrong, stays as it is.
BrushSettings withText(BrushSettings brush, const QByteArray& text)
{
    return withRemembered(std::move(brush),
                          nlohmann::json::parse(text.begin(), text.end(), nullptr, false));
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
