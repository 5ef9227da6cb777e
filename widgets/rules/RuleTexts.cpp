// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleTexts.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtGui/QColor>

#include "model/rules/RuleSequence.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/state/FeatureTexts.h"
#include "widgets/state/RelationTexts.h"

/// Rules as sentences.
namespace crowd::widgets {

using namespace model;

namespace {

struct RuleTextsContext
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

QString number(float value)
{
    return QLocale().toString(static_cast<double>(value), 'g', 3);
}

/// What stands for something that is still to be chosen.
QString openText()
{
    return RuleTextsContext::tr("…");
}

/// An entry of the scene by its id; `none` stands for 0.
template<class Entry>
QString entryText(const std::vector<Entry>& entries, std::int64_t id, const QString& none)
{
    const auto found = std::ranges::find(entries, id, &Entry::id);
    return id == 0                          ? none
           : id == std::int64_t{kNotChosen} ? openText()
           : found != entries.end()         ? QString::fromStdString(found->name)
                                            : RuleTextsContext::tr("(gone)");
}

QString featureName(const Scene& scene, std::int64_t id, const QString& none)
{
    const bool isOne = id > 0 && id <= std::int64_t{0xFFFF};
    const FeatureValue* value =
        isOne ? findFeature(scene.features, static_cast<FeatureId>(id)) : nullptr;
    return value != nullptr ? featureText(value->name)
                            : entryText(allFeatures(scene.features), id, none);
}

QString integerText(const Scene& scene, const FieldMeta& meta, std::int64_t value)
{
    const QString none = *meta.zero == 0 ? openText() : ruleText(meta.zero);
    switch (meta.role) {
    case FieldRole::Place:
        return entryText(scene.places, value, none);
    case FieldRole::Path:
        return entryText(scene.paths, value, none);
    case FieldRole::Group:
        return entryText(scene.groups, value, none);
    case FieldRole::ArtistNumber:
        return entryText(scene.numbers, value, RuleTextsContext::tr("a number"));
    case FieldRole::State:
        return entryText(scene.states, value, none);
    case FieldRole::Light:
        return entryText(scene.lights, value, none);
    case FieldRole::Feature:
        return featureName(scene, value, none);
    case FieldRole::Relation:
        return entryText(relationEntries(scene), value, none);
    case FieldRole::Template:
        return entryText(scene.templates, value, RuleTextsContext::tr("(gone)"));
    case FieldRole::Tag:
        return tagText(scene, static_cast<std::uint8_t>(value));
    default:
        break;
    }
    const auto index = static_cast<std::size_t>(value);
    return index < meta.choices.size() ? ruleText(meta.choices[index].label)
                                       : QLocale().toString(static_cast<qlonglong>(value));
}

QString clipsText(const std::vector<ClipWeight>& clips)
{
    QStringList names;
    for (const ClipWeight& clip : clips) {
        names << QString::fromStdString(clip.clip);
    }
    return names.isEmpty() ? openText() : names.join(RuleTextsContext::tr(" or "));
}

/// As people call it.
QString colourName(const QColor& color)
{
    constexpr float kDark = 0.15F;
    constexpr float kPale = 0.15F;
    const float value = color.valueF();
    if (value < kDark) {
        return RuleTextsContext::tr("black");
    }
    if (color.hsvSaturationF() < kPale) {
        return value > 0.85F ? RuleTextsContext::tr("white") : RuleTextsContext::tr("grey");
    }
    const int hue = color.hsvHue();
    if (hue >= 15 && hue < 45 && value < 0.65F) {
        return RuleTextsContext::tr("brown");
    }
    return hue < 15    ? RuleTextsContext::tr("red")
           : hue < 45  ? RuleTextsContext::tr("orange")
           : hue < 70  ? RuleTextsContext::tr("yellow")
           : hue < 165 ? RuleTextsContext::tr("green")
           : hue < 195 ? RuleTextsContext::tr("turquoise")
           : hue < 255 ? RuleTextsContext::tr("blue")
           : hue < 290 ? RuleTextsContext::tr("purple")
           : hue < 340 ? RuleTextsContext::tr("pink")
                       : RuleTextsContext::tr("red");
}

QString valueText(const Scene& scene, const FieldMeta& meta, const FieldValue& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return integerText(scene, meta, *whole);
    }
    if (const auto* real = std::get_if<float>(&value)) {
        return number(*real * static_cast<float>(meta.shownScale));
    }
    if (const auto* clips = std::get_if<std::vector<ClipWeight>>(&value)) {
        return clipsText(*clips);
    }
    if (const auto* color = std::get_if<PaintColor>(&value)) {
        return colourName(QColor((*color)[0], (*color)[1], (*color)[2]));
    }
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? QString::fromStdString(*text) : QString();
}

/// The sentence of a part, with its fields' values in their places.
template<class Data>
QString partText(const Scene& scene, const RulePart<Data>& part, bool isNegated = false,
                 const QString& inside = {})
{
    const RuleKind::AnySentence* sentence = sentenceOf(part.kind(), part.object());
    if (sentence == nullptr) {
        return {};
    }
    const QString text = ruleText(isNegated ? sentence->negated : sentence->text);
    QString filled;
    qsizetype from = 0;
    for (qsizetype open = text.indexOf(u'{'); open >= 0; open = text.indexOf(u'{', from)) {
        const qsizetype close = text.indexOf(u'}', open);
        const QString key = text.mid(open + 1, close - open - 1);
        const FieldInfo* field = shownField(part.kind(), part.object(), key.toStdString());
        filled += text.mid(from, open - from);
        filled +=
            field != nullptr ? valueText(scene, field->meta, field->get(part.object())) : inside;
        from = close + 1;
    }
    return filled + text.mid(from);
}

QString sequenceText(const Scene& scene, const Actions& actions, std::size_t begin,
                     std::size_t end);

QString blockText(const Scene& scene, const Actions& actions, std::size_t head)
{
    const std::size_t end = endOf(actions, head);
    return end == head + 1
               ? RuleTextsContext::tr("nothing")
               : RuleTextsContext::tr("(%1)").arg(sequenceText(scene, actions, head + 1, end));
}

/// "either (…) 70 % or (…) 30 %".
QString choiceText(const Scene& scene, const Actions& actions,
                   const std::vector<std::size_t>& lines)
{
    const auto weightOf = [&actions](std::size_t line) {
        return actions[line].as<actions::OneOf>()->weight;
    };
    float total = 0.0F;
    for (const std::size_t line : lines) {
        total += weightOf(line);
    }
    QStringList texts;
    for (const std::size_t line : lines) {
        const float share = total > 0.0F ? weightOf(line) / total : 0.0F;
        texts << RuleTextsContext::tr("%1 %2 %").arg(
            partText(scene, actions[line], false, blockText(scene, actions, line)),
            QLocale().toString(std::lround(100.0F * share)));
    }
    return RuleTextsContext::tr("either %1").arg(texts.join(RuleTextsContext::tr(" or ")));
}

/// What is done line by line, with what belongs to each.
QString sequenceText(const Scene& scene, const Actions& actions, std::size_t begin, std::size_t end)
{
    QStringList texts;
    for (std::size_t line = begin; line < end;) {
        const Action& action = actions[line];
        if (action.is<actions::OneOf>()) {
            const std::vector<std::size_t> lines = alternativesOf(actions, line);
            texts << choiceText(scene, actions, lines);
            line = endOf(actions, lines.back());
            continue;
        }
        const QString inside = isHead(action) ? blockText(scene, actions, line) : QString();
        texts << partText(scene, action, false, inside);
        line = endOf(actions, line);
    }
    return texts.join(RuleTextsContext::tr(", then "));
}

} // namespace

QString tagText(const Scene& scene, std::uint8_t tag)
{
    const auto named = std::ranges::find(scene.tags, tag, &TagName::bit);
    return named != scene.tags.end() && !named->name.empty()
               ? QString::fromStdString(named->name)
               : RuleTextsContext::tr("no. %1").arg(tag + 1);
}

QString ruleSentence(const Scene& scene, const Rule& rule)
{
    QString when = partText(scene, rule.trigger);
    QStringList conditions;
    for (const Condition& condition : rule.conditions) {
        conditions << partText(scene, condition, condition.isNot);
    }
    if (!conditions.isEmpty()) {
        when = RuleTextsContext::tr("%1 (%2)").arg(
            when, conditions.join(rule.isAnyEnough ? RuleTextsContext::tr(" or ")
                                                   : RuleTextsContext::tr(" and ")));
    }
    return RuleTextsContext::tr("%1: %2").arg(
        when, sequenceText(scene, rule.actions, 0, rule.actions.size()));
}

} // namespace crowd::widgets
