// SPDX-License-Identifier: MIT
#include "app/window/BrushMemory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QSettings>

#include "widgets/state/ToolId.h"

namespace crowd::app {

namespace {

using model::BrushSettings;

constexpr int kSaveMs = 1000;
constexpr qsizetype kMostEntries = 256; ///< of a list

QString keyOf(const widgets::ToolInfo& tool)
{
    return QStringLiteral("brushes/") + QLatin1String(tool.stableId);
}

QJsonValue toJson(const model::PaintColor& color)
{
    return QJsonArray{color[0], color[1], color[2]};
}

QJsonValue toJson(const model::ClipWeight& clip)
{
    return QJsonArray{QString::fromStdString(clip.clip), static_cast<double>(clip.weight)};
}

void fromJson(const QJsonValue& json, model::PaintColor& color)
{
    for (qsizetype i = 0; i < 3; ++i) {
        const int value = std::clamp(json.toArray().at(i).toInt(), 0, 255);
        color[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value);
    }
}

void fromJson(const QJsonValue& json, model::ClipWeight& clip)
{
    clip.clip = json.toArray().at(0).toString().toStdString();
    clip.weight = std::clamp(static_cast<float>(json.toArray().at(1).toDouble(1.0)), 0.01F, 1.0F);
}

/// Writes what it is shown into an object.
struct Writer
{
    QJsonObject json;

    void number(const char* key, float value, float, float)
    {
        json[QLatin1String(key)] = static_cast<double>(value);
    }
    void flag(const char* key, bool value) { json[QLatin1String(key)] = value; }
    void text(const char* key, const std::string& value)
    {
        json[QLatin1String(key)] = QString::fromStdString(value);
    }
    template<class Enum>
    void choice(const char* key, Enum value, Enum)
    {
        json[QLatin1String(key)] = static_cast<int>(value);
    }
    template<class Entry>
    void list(const char* key, const std::vector<Entry>& entries)
    {
        QJsonArray array;
        for (const Entry& entry : entries) {
            array << toJson(entry);
        }
        json[QLatin1String(key)] = array;
    }
};

/// Sets what it is shown from an object; what is not there, or is none, stays as it is.
struct Reader
{
    QJsonObject json;

    void number(const char* key, float& value, float low, float high)
    {
        const QJsonValue found = json[QLatin1String(key)];
        if (found.isDouble() && std::isfinite(found.toDouble())) {
            value = std::clamp(static_cast<float>(found.toDouble()), low, high);
        }
    }
    void flag(const char* key, bool& value) { value = json[QLatin1String(key)].toBool(value); }
    void text(const char* key, std::string& value)
    {
        value = json[QLatin1String(key)].toString(QString::fromStdString(value)).toStdString();
    }
    template<class Enum>
    void choice(const char* key, Enum& value, Enum last)
    {
        const int found = json[QLatin1String(key)].toInt(-1);
        if (found >= 0 && found <= static_cast<int>(last)) {
            value = static_cast<Enum>(found);
        }
    }
    template<class Entry>
    void list(const char* key, std::vector<Entry>& entries)
    {
        const QJsonValue value = json[QLatin1String(key)];
        const QJsonArray found = value.toArray();
        if (!value.isArray() || found.size() > kMostEntries) {
            return;
        }
        entries.clear();
        for (const auto each : found) {
            fromJson(each, entries.emplace_back());
        }
    }
};

template<class Archive, class Range>
void describe(Archive& archive, const char* low, const char* high, Range& range, float least,
              float most)
{
    archive.number(low, range.low, least, most);
    archive.number(high, range.high, least, most);
}

template<class Archive, class Heading>
void describeHeading(Archive& archive, Heading& heading)
{
    constexpr float kHalf = std::numbers::pi_v<float>;
    archive.choice("facing", heading.mode, model::HeadingMode::TowardsViewer);
    archive.number("heading", heading.headingRadians, -kHalf, kHalf);
    archive.number("spread", heading.spreadRadians, 0.0F, kHalf);
    archive.number("turn", heading.turnRadians, -kHalf, kHalf);
}

template<class Archive, class Create>
void describeCreation(Archive& archive, Create& create)
{
    archive.number("distance", create.minimalDistance, 0.1F, 10.0F);
    describe(archive, "lowestHeight", "highestHeight", create.height, 0.5F, 2.0F);
    describe(archive, "lowestGirth", "highestGirth", create.girth, 0.5F, 2.0F);
    archive.list("colours", create.palette);
    archive.number("tint", create.paletteStrength, 0.0F, 1.0F);
    archive.flag("outfits", create.variesOutfit);
    archive.flag("parts", create.variesParts);
    describe(archive, "lowestPhase", "highestPhase", create.phase, 0.0F, 1.0F);
    archive.list("clips", create.clips);
    archive.number("density", create.density, 0.05F, 6.0F);
    archive.number("seatPercent", create.seatPercent, 1.0F, 100.0F);
    archive.flag("anywhere", create.anywhere);
    describeHeading(archive, create.heading);
}

template<class Archive, class Settings>
void describeArea(Archive& archive, Settings& brush)
{
    archive.choice("selection", brush.selection, model::BrushSelection::Rectangle);
    archive.choice("operator", brush.op, model::BrushOperator::Gradient);
    archive.number("radius", brush.radiusPixels, model::kMinRadiusPixels, model::kMaxRadiusPixels);
    archive.number("rate", brush.ratePerSecond, 1.0F, 500.0F);
    archive.flag("through", brush.through);
    archive.flag("buildUp", brush.buildUp);
    archive.number("flow", brush.flow, 0.01F, 1.0F);
    archive.flag("pressureSize", brush.pressureSize);
    archive.flag("pressureRate", brush.pressureRate);
    static constexpr std::array kBins{"f0", "f1", "f2",  "f3",  "f4",  "f5",  "f6",  "f7",
                                      "f8", "f9", "f10", "f11", "f12", "f13", "f14", "f15"};
    for (std::size_t bin = 0; bin < kBins.size(); ++bin) {
        archive.number(kBins[bin], brush.distribution.weights[bin], 0.0F, 1.0F);
    }
}

/// Of one kind of brush, with what it can be set to; once for reading and writing.
template<class Archive, class Settings>
void describe(Archive& archive, Settings& brush)
{
    describeArea(archive, brush);
    switch (brush.kind) {
    case model::BrushKind::Create:
        describeCreation(archive, brush.create);
        break;
    case model::BrushKind::Delete:
        archive.number("percent", brush.removal.percent, 1.0F, 100.0F);
        break;
    case model::BrushKind::Colour:
        archive.list("colours", brush.colour.colors);
        archive.number("strength", brush.colour.strength, 0.0F, 1.0F);
        archive.flag("replaces", brush.colour.replaces);
        archive.flag("blends", brush.colour.blends);
        archive.flag("eachSlotApart", brush.colour.eachSlotApart);
        break;
    case model::BrushKind::Orientation:
        describeHeading(archive, brush.orientation.heading);
        break;
    case model::BrushKind::Animation:
        archive.list("clips", brush.animation.clips);
        archive.flag("setsPhase", brush.animation.setsPhase);
        describe(archive, "lowestPhase", "highestPhase", brush.animation.phase, 0.0F, 1.0F);
        archive.flag("setsSpeed", brush.animation.setsSpeed);
        describe(archive, "slowest", "fastest", brush.animation.speed, 0.0F, 10.0F);
        break;
    case model::BrushKind::Walk:
        archive.flag("setsPath", brush.walk.setsPath);
        archive.flag("setsSpeed", brush.walk.setsSpeed);
        describe(archive, "slowest", "fastest", brush.walk.speed, 0.0F, 10.0F);
        break;
    case model::BrushKind::Style:
        archive.flag("setsStyle", brush.style.setsStyle);
        archive.list("clips", brush.style.clips);
        archive.flag("setsSpeed", brush.style.setsSpeed);
        describe(archive, "slowest", "fastest", brush.style.speed, 0.0F, 10.0F);
        break;
    case model::BrushKind::Event:
        archive.text("event", brush.event.name);
        archive.number("payload", brush.event.payload, -1e6F, 1e6F);
        break;
    case model::BrushKind::Path:
    case model::BrushKind::Environment:
        archive.number("placeRadius", brush.place.radiusMetres, 0.1F, 50.0F);
        archive.choice("pathKind", brush.place.kind, model::PathKind::Teleport);
        archive.choice("role", brush.place.role, model::PlaceRole::Preferred);
        archive.flag("anywhere", brush.place.anywhere);
        break;
    case model::BrushKind::Tag:
    case model::BrushKind::Untag:
    case model::BrushKind::Script:
        break;
    }
}

QByteArray textOf(const BrushSettings& brush)
{
    Writer writer;
    describe(writer, brush);
    return QJsonDocument(writer.json).toJson(QJsonDocument::Compact);
}

BrushSettings withText(BrushSettings brush, const QByteArray& text)
{
    Reader reader{QJsonDocument::fromJson(text).object()};
    describe(reader, brush);
    if (brush.colour.colors.empty()) {
        brush.colour.colors = BrushSettings().colour.colors; // it is never empty
    }
    for (model::ValueRange* range :
         {&brush.create.height, &brush.create.girth, &brush.create.phase, &brush.animation.phase,
          &brush.animation.speed, &brush.walk.speed, &brush.style.speed}) {
        range->high = std::max(range->low, range->high);
    }
    return brush;
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
            const BrushSettings fresh = widgets::initialBrush(*tool.brush);
            m_state.setBrush(withText(m_state.brush(*tool.brush), textOf(fresh)));
        }
    }
}

} // namespace crowd::app
