// SPDX-License-Identifier: MIT
#include "app/commands/BenchStates.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "app/commands/BenchReport.h"
#include "behavior/session/Session.h"
#include "model/base/Random.h"
#include "model/brush/ByteChange.h"
#include "model/document/SceneEdit.h"
#include "model/population/Properties.h"
#include "model/states/StateKeeping.h"

namespace crowd::app {

namespace {

using namespace model;

constexpr int kRecalls = 7;
constexpr int kFadeFrames = 15;

double medianOfStates(std::vector<double> samples)
{
    std::ranges::sort(samples);
    return samples[samples.size() / 2];
}

template<class Work>
double stateMilliseconds(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::vector<IndividualId> allPeopleOf(const Scene& scene)
{
    return {scene.population.ids().begin(), scene.population.ids().end()};
}

/// Everybody gets values of his own in what can be painted.
void shuffleColumns(const std::vector<IndividualId>& ids, const WriteColumn& write,
                    std::uint64_t seed)
{
    const auto put = [&](auto key, const auto& valueOf) {
        std::vector<decltype(valueOf(std::uint64_t{}))> values;
        values.reserve(ids.size());
        for (const IndividualId id : ids) {
            values.push_back(valueOf(hashKeys(seed, static_cast<std::uint64_t>(key.id), id)));
        }
        write(key.id, ids, std::as_bytes(std::span(values)));
    };
    for (int slot = 0; slot < 8; ++slot) {
        put(columns::tint(slot), [](std::uint64_t bits) {
            return Tint{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                        static_cast<std::uint8_t>(bits >> 16U), 255};
        });
    }
    const auto aboutOne = [](std::uint64_t bits) { return 0.9F + 0.2F * unitFloat(bits); };
    put(columns::height, aboutOne);
    put(columns::girth, aboutOne);
    put(columns::playbackSpeed, aboutOne);
    put(columns::phase, [](std::uint64_t bits) { return unitFloat(bits); });
    put(columns::clip, [](std::uint64_t bits) { return static_cast<std::uint16_t>(bits % 4); });
    put(columns::tags, [](std::uint64_t bits) { return bits; });
    put(columns::tintReplaces,
        [](std::uint64_t bits) { return static_cast<std::uint16_t>(bits & 0xFFU); });
}

/// Frames of a session that is half way there.
double medianSessionFrame(behavior::Session& session, int steps)
{
    std::vector<double> samples;
    for (int i = 0; i < kFadeFrames; ++i) {
        for (int step = 0; step < steps; ++step) {
            session.step();
        }
        samples.push_back(stateMilliseconds([&session] { (void)session.frame(); }));
    }
    return medianOfStates(samples);
}

} // namespace

void measureStates(SceneDocument& document, QJsonObject& report)
{
    const auto shuffled = [&document](std::uint64_t seed) {
        document.edit(QStringLiteral("Shuffle"), [seed](SceneEdit& edit) {
            shuffleColumns(
                allPeopleOf(edit.scene()), [&edit](auto... what) { edit.setColumn(what...); },
                seed);
        });
    };
    shuffled(1);
    State state;
    report[QStringLiteral("state_keep_ms")] = rounded(stateMilliseconds([&] {
        state = keepState(document.scene(), "all", usualStateColumns(),
                          document.scene().population.ids());
    }));
    shuffled(2);
    const Scene before = document.scene();
    std::vector<double> recalls;
    std::vector<double> undos;
    for (int i = 0; i < kRecalls; ++i) {
        recalls.push_back(stateMilliseconds([&] {
            document.edit(QStringLiteral("Recall"), [&state](SceneEdit& edit) {
                (void)recallState(edit, state, state.columns);
            });
        }));
        undos.push_back(stateMilliseconds([&document] { document.undoStack().undo(); }));
    }
    report[QStringLiteral("state_recall_ms")] = rounded(medianOfStates(recalls));
    report[QStringLiteral("state_undo_ms")] = rounded(medianOfStates(undos));
    behavior::Session session(before);
    report[QStringLiteral("session_frame_ms")] = rounded(medianSessionFrame(session, 1));
    document.undoStack().redo();
    ChangeOver change{1, peopleOf(before, state), state.columns, {20.0F, {}}};
    session.adopt(document.scene(), change);
    report[QStringLiteral("fade_frame_ms")] = rounded(medianSessionFrame(session, 1));
}

void shuffleLooks(Scene& scene, std::uint64_t seed)
{
    shuffleColumns(
        allPeopleOf(scene), [&scene](auto... what) { scene.population.setValues(what...); }, seed);
}

} // namespace crowd::app
