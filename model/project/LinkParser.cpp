// SPDX-License-Identifier: MIT
#include "model/project/LinkParser.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <nlohmann/json.hpp>

namespace crowd::model {

namespace {

constexpr const char* kIdExpected =
    QT_TRANSLATE_NOOP("Messages", "the id of an individual, a whole number above zero");
constexpr const char* kKindExpected =
    QT_TRANSLATE_NOOP("Messages", "the id of a kind of relation, from 1 to 64");
constexpr const char* kStrengthExpected = QT_TRANSLATE_NOOP("Messages", "a number from 0 to 1");

bool isWholeId(const CellValue& value, std::uint64_t most)
{
    return value.kind == CellValue::Kind::Unsigned && value.integer > 0 && value.integer <= most;
}

bool readStrength(const CellValue& value, float& strength)
{
    if (value.kind == CellValue::Kind::Unsigned) {
        strength = static_cast<float>(value.integer);
        return value.integer <= 1;
    }
    double read = -1.0;
    const char* end = value.text.data() + value.text.size();
    if (value.kind == CellValue::Kind::Float) {
        (void)std::from_chars(value.text.data(), end, read);
    }
    strength = static_cast<float>(read);
    return read >= 0.0 && read <= 1.0;
}

} // namespace

Result<void> LinkParser::begin(const nlohmann::json& names)
{
    nlohmann::json known = nlohmann::json::array();
    for (const char* name : kLinkColumns) {
        known.push_back(name);
    }
    if (m_isBegun || names != known) {
        return Error{
            QT_TRANSLATE_NOOP("Messages",
                              "relations.columns must stand before the rows, once, and be %1"),
            known.dump()};
    }
    m_isBegun = true;
    return {};
}

const char* LinkParser::put(const CellValue& value)
{
    constexpr std::uint64_t kMostId = std::numeric_limits<IndividualId>::max();
    switch (m_cell++) {
    case 0:
        m_next.from = static_cast<IndividualId>(value.integer);
        return isWholeId(value, kMostId) ? nullptr : kIdExpected;
    case 1:
        m_next.to = static_cast<IndividualId>(value.integer);
        return isWholeId(value, kMostId) ? nullptr : kIdExpected;
    case 2:
        m_next.kind = static_cast<RelationKindId>(value.integer);
        return isWholeId(value, kMostRelationKinds) ? nullptr : kKindExpected;
    default:
        return readStrength(value, m_next.strength) ? nullptr : kStrengthExpected;
    }
}

bool LinkParser::endRow()
{
    const bool isWhole = m_cell == kLinkColumns.size();
    m_cell = 0;
    if (isWhole) {
        m_relations.push_back(m_next);
    }
    return isWhole;
}

void LinkParser::fill(Scene& scene) const
{
    std::vector<Relation> sound;
    sound.reserve(m_relations.size());
    for (const Relation& each : m_relations) {
        const RelationKind* kind = findRelation(scene.relationKinds, each.kind);
        const bool areThere = scene.population.rowOf(each.from) != Population::npos &&
                              scene.population.rowOf(each.to) != Population::npos;
        if (kind != nullptr && areThere && each.from != each.to) {
            sound.push_back(canonical(*kind, each));
        }
    }
    scene.relations.put(sound);
    const std::size_t lost = m_relations.size() - sound.size();
    const std::size_t twice = sound.size() - scene.relations.count();
    if (lost > 0) {
        scene.readWarnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "%1 relations are left out: they are of individuals or kinds that "
                              "the scene has not, or of somebody to himself"),
            lost);
    }
    if (twice > 0) {
        scene.readWarnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "%1 relations stood there twice: the last ones count"),
            twice);
    }
}

} // namespace crowd::model
