// SPDX-License-Identifier: MIT
#include "behavior/motion/StrideKernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "behavior/crowd/Avx2.h"
#include "behavior/crowd/PackOrders.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

bool isInShape(const SlowArea& area, float x, float z)
{
    return model::isWithin(*area.shape, {x, area.shape->position.y, z});
}

namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;

/// People after turning, from the first of a block on.
struct Turned
{
    float x[kStrideBlock];
    float z[kStrideBlock];
    float speed[kStrideBlock];
    float preferred[kStrideBlock];
    float heading[kStrideBlock];
};

#define CROWD_KERNEL_BODY "behavior/motion/StrideKernelBody.h"
#include "behavior/crowd/KernelCopies.h"

} // namespace

std::size_t steerStraightOn(std::span<Body> bodies, const Aims& aims,
                            std::span<const SlowArea> slow, std::size_t begin, std::size_t end,
                            std::uint32_t* needUpdate, [[maybe_unused]] bool hasPlainInstructions)
{
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !hasPlainInstructions) {
        return with_avx2::steer(bodies, aims, slow, begin, end, needUpdate);
    }
#endif
    return any_processor::steer(bodies, aims, slow, begin, end, needUpdate);
}

std::size_t strideOn(std::span<const Body> bodies, std::span<const float> heights,
                     MotionState& motion, const StrideParameters& parameters, std::size_t begin,
                     std::size_t end, std::uint32_t* needUpdate)
{
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !parameters.hasPlainInstructions) {
        return with_avx2::stride(bodies, heights, motion, parameters, begin, end, needUpdate);
    }
#endif
    return any_processor::stride(bodies, heights, motion, parameters, begin, end, needUpdate);
}

} // namespace crowd::behavior
