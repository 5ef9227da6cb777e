// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QtCore/QtGlobal>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/base/Values.h"

/// The second step of a brush: how a value varies over the individuals that are meant. An operator
/// is a struct with kInfo and evaluate(), which works on all of them at once.
namespace crowd::model {

class View;

/// The pointer's way so far, for operators that follow it. Logical pixels.
struct StrokeLine
{
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};

/// For whom an operator says something.
struct OperatorRequest
{
    const View& view;
    StrokeLine line;        ///< press to current
    std::uint64_t seed = 0; ///< of the stroke; with the dab mixed in where dabs build up
    const DistributionCurve& distribution;
    std::uint64_t purpose = 0; ///< what the value is for: draws of one individual differ by it
    std::uint64_t extra = 0;   ///< tells draws for one purpose apart
    std::span<const IndividualId> ids;
    std::span<const glm::vec3> positions; ///< where they are seen, one each; world, metres
};

/// What it says.
struct OperatorResult
{
    std::vector<double> shares; ///< 0..1, one each
    bool isDraw = false;        ///< of several values one is meant, not a mixture
    /// A value of its own for each, where the operator brings one (a picture, a sample); else
    /// empty.
    std::vector<PaintColor> colors{};
};

struct OperatorInfo
{
    const char* key;               ///< member of crowdbrush.Operator
    const char* label;             ///< in the translation context "Fields"
    bool usesDistribution = false; ///< the artist draws how often values come
    bool followsLine = false;      ///< strokes are evaluated anew from press to current
};

} // namespace crowd::model
