// SPDX-License-Identifier: MIT
#include "app/commands/BenchRelations.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/commands/BenchReport.h"
#include "model/base/Random.h"
#include "model/brush/RelationStroke.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"

namespace crowd::app {

namespace {

using namespace model;

constexpr std::size_t kRelationsEach = 10;
constexpr std::size_t kDabSide = 23; ///< people: some 500 a dab
constexpr std::size_t kRelationDabs = 40;

template<class Work>
double relationMilliseconds(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::vector<Relation> manyRelations(const Population& people)
{
    const auto ids = people.ids();
    std::vector<Relation> all;
    all.reserve(ids.size() * kRelationsEach);
    for (const IndividualId from : ids) {
        for (std::size_t i = 0; i < kRelationsEach; ++i) {
            const std::uint64_t bits = hashKeys(from, i);
            all.push_back({from, ids[bits % ids.size()], unitFloat(bits), 4});
        }
    }
    return all;
}

/// The median of dabs, each of so many people whom the stroke has not met yet.
double medianDab(SceneDocument& document, RelationHow how)
{
    BrushSettings brush(BrushKind::Relation);
    brush.as<RelationSettings>().how = how;
    brush.as<RelationSettings>().relation = "friends";
    const Population people = document.scene().population;
    const auto ids = people.ids();
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(ids.size())));
    const std::size_t blocks = std::max<std::size_t>(1, side / kDabSide);
    std::vector<double> samples;
    document.edit(QStringLiteral("Relate"), [&](SceneEdit& edit) {
        RelationStroke stroke(brush, 7);
        for (std::size_t dab = 0; dab < std::min(kRelationDabs, blocks * blocks); ++dab) {
            std::vector<IndividualId> touched; // a square of those who stand in rows
            for (std::size_t i = 0; i < kDabSide * kDabSide; ++i) {
                const std::size_t row = dab / blocks * kDabSide + i / kDabSide;
                const std::size_t at = row * side + dab % blocks * kDabSide + i % kDabSide;
                if (at < ids.size()) {
                    touched.push_back(ids[at]);
                }
            }
            std::ranges::sort(touched);
            samples.push_back(relationMilliseconds([&] {
                stroke.add(edit, people, touched);
                stroke.settle(edit);
            }));
        }
    });
    document.undoStack().undo();
    std::ranges::sort(samples);
    return samples[samples.size() / 2];
}

} // namespace

void measureRelations(SceneDocument& document, QJsonObject& report)
{
    const std::vector<Relation> all = manyRelations(document.scene().population);
    report[QStringLiteral("relation_make_ms")] = rounded(relationMilliseconds([&] {
        document.edit(QStringLiteral("Relate"), [&all](SceneEdit& edit) { edit.relate(all); });
    }));
    report[QStringLiteral("relation_count")] =
        static_cast<double>(document.scene().relations.count());
    report[QStringLiteral("relation_undo_ms")] =
        rounded(relationMilliseconds([&document] { document.undoStack().undo(); }));
    document.undoStack().redo();
    report[QStringLiteral("relation_near_dab_ms")] =
        rounded(medianDab(document, RelationHow::Near));
    report[QStringLiteral("relation_chain_dab_ms")] =
        rounded(medianDab(document, RelationHow::Chain));
    report[QStringLiteral("relation_family_dab_ms")] =
        rounded(medianDab(document, RelationHow::Family));
    std::string text;
    report[QStringLiteral("relation_save_ms")] = rounded(relationMilliseconds([&] {
        auto written = projectToText(document.scene());
        text = written ? std::move(written).value() : std::string();
    }));
    report[QStringLiteral("relation_load_ms")] =
        rounded(relationMilliseconds([&text] { (void)projectFromText(text); }));
    report[QStringLiteral("relation_parse_floor_ms")] =
        rounded(relationMilliseconds([&text] { (void)nlohmann::json::accept(text); }));
}

} // namespace crowd::app
