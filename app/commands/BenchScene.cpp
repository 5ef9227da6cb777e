// SPDX-License-Identifier: MIT
#include "app/commands/BenchScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/base/Random.h"

namespace crowd::app {

namespace {

using namespace model;

constexpr float kNearest = 17.0F;           ///< metres: 90 pixels
constexpr float kFarthest = 50.0F;          ///< metres: 30 pixels, for up to 1000 people
constexpr float kHalfWidthPerDepth = 0.66F; ///< of a 16:9 picture
constexpr float kEyeHeight = 5.0F;

enum class Purpose : std::uint64_t { Clip, Phase, Tint, Height, Heading, Shuffle };

float random(IndividualId id, Purpose purpose)
{
    return unitFloat(hashKeys(std::uint64_t{7}, id, purpose));
}

Tint randomTint(IndividualId id, std::uint64_t slot)
{
    const std::uint64_t bits = hashKeys(std::uint64_t{11}, id, slot);
    const auto channel = [bits](unsigned shift) {
        return static_cast<std::uint8_t>(80 + ((bits >> shift) & 0x7FU));
    };
    return {channel(0), channel(8), channel(16), 200};
}

TemplateEntry entryFor(const TemplatePtr& asset, TemplateId id)
{
    TemplateEntry entry;
    entry.id = id;
    entry.name = asset->name;
    entry.asset = asset;
    for (const Clip& clip : asset->clips) {
        entry.clipNames.push_back(clip.name);
    }
    return entry;
}

void fill(IndividualRows& rows, std::size_t i, const TemplateEntry& entry)
{
    const IndividualId id = rows.ids[i];
    rows.column(columns::templateId)[i] = entry.id;
    rows.column(columns::heading)[i] = random(id, Purpose::Heading) * 1.2F - 0.6F;
    rows.column(columns::height)[i] = 0.95F + 0.1F * random(id, Purpose::Height);
    rows.column(columns::girth)[i] = 1.0F;
    rows.column(columns::parts)[i] = 0xFFFFFFFFU;
    const auto clips = static_cast<float>(entry.clipNames.size());
    rows.column(columns::clip)[i] = static_cast<std::uint16_t>(random(id, Purpose::Clip) * clips);
    rows.column(columns::phase)[i] = random(id, Purpose::Phase);
    rows.column(columns::playbackSpeed)[i] = 1.0F;
    for (int slot = 0; slot < kMaxTintSlots; ++slot) {
        rows.column(columns::tint(slot))[i] = randomTint(id, static_cast<std::uint64_t>(slot));
    }
}

} // namespace

Scene makeBenchField(const std::vector<TemplatePtr>& assets, int count, bool isFar)
{
    Scene scene;
    scene.name = "field";
    for (const TemplatePtr& asset : assets) {
        scene.templates.push_back(
            entryFor(asset, static_cast<TemplateId>(scene.templates.size() + 1)));
    }
    std::vector<IndividualId> ids(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = static_cast<IndividualId>(i + 1);
    }
    IndividualRows rows = IndividualRows::withDefaults(ids);
    const float nearest = isFar ? kFarthest : kNearest;
    const float farthest =
        kFarthest * std::max(1.0F, std::sqrt(static_cast<float>(count) / 1000.0F)) + nearest -
        kNearest;
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<float>(count))));
    for (std::size_t i = 0; i < ids.size(); ++i) {
        fill(rows, i, scene.templates[i % scene.templates.size()]);
        const std::size_t row = i / columns;
        const float depth =
            nearest + (farthest - nearest) * static_cast<float>(row) / static_cast<float>(columns);
        const float side = (static_cast<float>(i % columns) + 0.5F) / static_cast<float>(columns);
        rows.column(model::columns::position)[i] = {
            (side * 2.0F - 1.0F) * kHalfWidthPerDepth * depth, 0.0F, -depth};
    }
    scene.population.add(rows);
    scene.nextId = static_cast<IndividualId>(count + 1);
    scene.cameras.push_back(
        {"bench", Camera::lookingAt({0.0F, kEyeHeight, 0.0F}, {0.0F, 1.0F, -farthest * 0.6F})});
    return scene;
}

void seatMore(Scene& scene, std::size_t count)
{
    const auto taken = scene.population.column(columns::seat);
    const std::set<SeatId> occupied(taken.begin(), taken.end());
    const std::vector<IndividualId> people(scene.population.ids().begin(),
                                           scene.population.ids().end());
    for (const WorldSeat& place : scene.worldSeats()) {
        const std::size_t now = scene.population.size();
        if (people.empty() || now >= count) {
            return;
        }
        if (occupied.contains(place.id)) {
            continue;
        }
        const std::array<IndividualId, 1> like{people[now % people.size()]};
        IndividualRows row = scene.population.rows(like);
        row.ids[0] = scene.nextId++;
        row.column(columns::position)[0] = place.seat.position;
        row.column(columns::heading)[0] = place.seat.headingRadians;
        row.column(columns::seat)[0] = place.id;
        scene.population.add(row);
    }
}

void keepPeople(Scene& scene, std::size_t count)
{
    std::vector<IndividualId> ids(scene.population.ids().begin(), scene.population.ids().end());
    if (ids.size() <= count) {
        return;
    }
    std::ranges::sort(ids, [](IndividualId a, IndividualId b) {
        const std::uint64_t keyA = hashKeys(a, Purpose::Shuffle);
        const std::uint64_t keyB = hashKeys(b, Purpose::Shuffle);
        return keyA != keyB ? keyA < keyB : a < b;
    });
    std::vector<IndividualId> dropped(ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end());
    std::ranges::sort(dropped);
    (void)scene.population.remove(dropped);
}

} // namespace crowd::app
