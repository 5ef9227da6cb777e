// SPDX-License-Identifier: MIT
#include "app/commands/BenchMotion.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <vector>

#include <QtCore/QJsonObject>

#include "app/commands/BenchReport.h"
#include "behavior/session/MotionCache.h"
#include "behavior/session/MotionReader.h"
#include "behavior/takes/Retake.h"
#include "behavior/workload/Workload.h"
#include "model/base/Random.h"

namespace crowd::app {

namespace {

constexpr std::uint64_t kMotionSeed = 1;
constexpr int kSeeks = 400;
constexpr std::size_t kRetakenOf = 10;
constexpr double kRetakeSeconds = 10.0;

/// A share of the values that are smaller; `values` has one at least.
double quantile(std::vector<double> values, double share)
{
    std::ranges::sort(values);
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(last * share)];
}

/// How long it takes to have moments at random; negative: one could not be had.
std::vector<double> seek(const std::shared_ptr<behavior::MotionCache>& cache)
{
    behavior::MotionReader reader(cache);
    const behavior::MotionCache::Extent kept = cache->extent();
    std::vector<double> times;
    times.reserve(kSeeks);
    for (std::uint64_t i = 0; i < kSeeks; ++i) {
        const double share = static_cast<double>(model::mixBits(kMotionSeed + i) >> 11U) * 0x1p-53;
        const double begin = nowMs();
        const bool isThere =
            reader.around(kept.first + share * (kept.last - kept.first)).first != nullptr;
        times.push_back(isThere ? nowMs() - begin : -1.0);
    }
    return times;
}

/// How long it takes that every tenth acts again for ten seconds, and all others do what they did;
/// negative: it cannot be done.
double retakeSeconds(const behavior::Workload& crowd,
                     const std::shared_ptr<behavior::MotionCache>& cache)
{
    const behavior::MotionCache::Extent kept = cache->extent();
    behavior::RetakeWish wish;
    const auto ids = crowd.scene()->population.ids();
    for (std::size_t i = 0; i < ids.size(); i += kRetakenOf) {
        wish.people.push_back(ids[i]);
    }
    wish.begin = std::max(kept.first, (kept.first + kept.last - kRetakeSeconds) / 2.0);
    wish.end = wish.begin + kRetakeSeconds;
    wish.seed = 1;
    const double begin = nowMs();
    const auto made = behavior::retake(*crowd.scene(), cache, wish, nullptr);
    return made ? (nowMs() - begin) / 1000.0 : -1.0;
}

} // namespace

int runBenchMotion(const BenchMotionOptions& options)
{
    auto made =
        behavior::makeWorkload("paths", static_cast<std::size_t>(options.count), kMotionSeed);
    if (!made) {
        std::cerr << made.error().message << '\n';
        return 1;
    }
    behavior::Workload& crowd = *made.value();
    const auto cache = std::make_shared<behavior::MotionCache>();
    double stepMs = 0.0;
    double writeMs = 0.0;
    for (int frame = 0; frame < options.frames; ++frame) {
        const double begin = nowMs();
        crowd.step();
        const double stepped = nowMs();
        cache->add(crowd.pose());
        stepMs += stepped - begin;
        writeMs += nowMs() - stepped;
    }
    const auto [memory, disk] = cache->bytes();
    const std::vector<double> seeks = seek(cache);
    if (std::ranges::min(seeks) < 0.0) {
        std::cerr << "a step that was kept could not be read again\n";
        return 1;
    }
    const auto steps = static_cast<double>(cache->extent().steps);
    QJsonObject report{{QStringLiteral("count"), options.count},
                       {QStringLiteral("frames"), options.frames},
                       {QStringLiteral("frames_kept"), steps}};
    report[QStringLiteral("bytes_per_person_step")] =
        rounded(static_cast<double>(memory + disk) / (steps * options.count));
    report[QStringLiteral("disk_bytes")] = static_cast<double>(disk);
    report[QStringLiteral("step_ms")] = rounded(stepMs / options.frames);
    report[QStringLiteral("write_percent")] = rounded(100.0 * writeMs / stepMs);
    report[QStringLiteral("seek_ms_p50")] = rounded(quantile(seeks, 0.5));
    report[QStringLiteral("seek_ms_p99")] = rounded(quantile(seeks, 0.99));
    report[QStringLiteral("retake_seconds")] = rounded(retakeSeconds(crowd, cache));
    printReport(report, options.json);
    return 0;
}

} // namespace crowd::app
