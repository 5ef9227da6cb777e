// SPDX-License-Identifier: MIT
#include "model/base/Color.h"

#include <cmath>

namespace crowd::model {

float linearFromSrgb(float encoded)
{
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float srgbFromLinear(float linear)
{
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

glm::vec3 linearFromSrgb(const glm::vec3& encoded)
{
    return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

} // namespace crowd::model
