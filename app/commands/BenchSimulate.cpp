// SPDX-License-Identifier: MIT
#include "app/commands/BenchSimulate.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <optional>

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "app/commands/BenchReport.h"
#include "behavior/validation/Validation.h"
#include "behavior/workload/WorkloadRun.h"
#include "model/base/Parallel.h"

namespace crowd::app {

namespace {

constexpr std::uint64_t kSeed = 1;

constexpr int kStepsABlock = 10;

bool isOnOneThread(const BenchSimulateOptions& options, int step)
{
    return options.againstOneThread && step / kStepsABlock % 2 == 1;
}

/// Times of the steps on one thread or on all of them, ascending.
std::vector<double> stepTimes(const BenchSimulateOptions& options,
                              const behavior::WorkloadFigures& figures, bool onOneThread)
{
    std::vector<double> times;
    for (std::size_t step = 0; step < figures.stepMs.size(); ++step) {
        if (isOnOneThread(options, static_cast<int>(step)) == onOneThread) {
            times.push_back(figures.stepMs[step]);
        }
    }
    std::ranges::sort(times);
    return times;
}

double median(const std::vector<double>& ascending)
{
    return ascending[ascending.size() / 2];
}

QJsonObject report(const BenchSimulateOptions& options, const behavior::WorkloadFigures& figures)
{
    const std::vector<double> stepMs = stepTimes(options, figures, false);
    const double totalMs = std::accumulate(stepMs.begin(), stepMs.end(), 0.0);
    const double agentSteps =
        static_cast<double>(options.count) * static_cast<double>(stepMs.size());
    QJsonObject object{{QStringLiteral("workload"), QString::fromStdString(options.workload)},
                       {QStringLiteral("count"), options.count},
                       {QStringLiteral("steps"), options.steps},
                       {QStringLiteral("threads"), options.threads}};
    object[QStringLiteral("agent_steps_per_second")] = std::round(agentSteps / totalMs * 1000.0);
    object[QStringLiteral("best_step_ms")] = rounded(stepMs.front());
    object[QStringLiteral("median_step_ms")] = rounded(median(stepMs));
    object[QStringLiteral("overlaps_per_1000")] = rounded(figures.overlapsPer1000);
    object[QStringLiteral("efficiency")] = rounded(figures.efficiency);
    object[QStringLiteral("rms_acceleration")] = rounded(figures.rmsAcceleration);
    object[QStringLiteral("bytes_per_agent")] = std::round(figures.bytesPerAgent);
    object[QStringLiteral("outside_walls")] = rounded(figures.outsideWalls);
    object[QStringLiteral("broken_numbers")] = static_cast<int>(figures.brokenNumbers);
    if (const std::vector<double> alone = stepTimes(options, figures, true); !alone.empty()) {
        object[QStringLiteral("one_thread_median_step_ms")] = rounded(median(alone));
        object[QStringLiteral("times_one_thread")] = rounded(median(alone) / median(stepMs));
    }
    return object;
}

/// A table, or an object with one list; 0 when all are within their limits.
int runValidation(bool isJson)
{
    QJsonArray list;
    bool isValid = true;
    for (const behavior::ValidationRow& row : behavior::validate()) {
        isValid = isValid && row.isWithin();
        if (isJson) {
            list.append(QJsonObject{{QStringLiteral("what"), QString::fromStdString(row.what)},
                                    {QStringLiteral("unit"), QString::fromStdString(row.unit)},
                                    {QStringLiteral("measured"), rounded(row.measured)},
                                    {QStringLiteral("low"), rounded(row.low)},
                                    {QStringLiteral("high"), rounded(row.high)},
                                    {QStringLiteral("within"), row.isWithin()}});
        } else {
            std::cout << row.text() << '\n';
        }
    }
    if (isJson) {
        printReport({{QStringLiteral("validation"), list}}, true);
    }
    return isValid ? 0 : 1;
}

} // namespace

int runBenchSimulate(const BenchSimulateOptions& options)
{
    if (options.validate) {
        return runValidation(options.json);
    }
    auto workload =
        behavior::makeWorkload(options.workload, static_cast<std::size_t>(options.count), kSeed);
    if (!workload) {
        std::cerr << workload.error().message << '\n';
        return 1;
    }
    const model::ThreadLimit limit(options.threads);
    behavior::Workload& crowd = *workload.value();
    if (options.slowing >= 0.0) {
        crowd.crowd().parameters.slowing = static_cast<float>(options.slowing);
    }
    std::optional<model::ThreadLimit> alone;
    const auto beforeStep = [&](int step) {
        if (!isOnOneThread(options, step)) {
            alone.reset();
        } else if (!alone) {
            alone.emplace(1);
        }
    };
    const behavior::WorkloadFigures figures =
        behavior::runWorkload(crowd, options.steps, &nowMs, beforeStep);
    printReport(report(options, figures), options.json);
    return 0;
}

} // namespace crowd::app
