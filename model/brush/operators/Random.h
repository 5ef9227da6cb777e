// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Random.h"
#include "model/brush/operators/OperatorRequest.h"

namespace crowd::model {

/// A draw for each, by the distribution; a pure function of seed, individual, purpose and extra.
struct RandomOperator
{
    static constexpr OperatorInfo kInfo{
        .key = "RANDOM", .label = QT_TRANSLATE_NOOP("Fields", "Random"), .usesDistribution = true};

    [[nodiscard]] static OperatorResult evaluate(const OperatorRequest& request)
    {
        OperatorResult result{{}, true};
        result.shares.reserve(request.ids.size());
        for (const IndividualId id : request.ids) {
            const std::uint64_t key = hashKeys(request.seed, id);
            result.shares.push_back(request.distribution.sample(
                unitDouble(hashKeys(key, request.purpose, request.extra))));
        }
        return result;
    }
};

} // namespace crowd::model
