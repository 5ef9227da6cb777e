// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "model/template/Template.h"

namespace crowd::model {

/// What a foreign model probably is, by the words of its names and how it is built.
enum class BodyKind : std::uint8_t { Thing, Person, Animal, Vehicle, Flyer };

/// A kind, and how large its like is. Metres: of people the height, of all else the largest extent.
struct BodyGuess
{
    BodyKind kind = BodyKind::Thing;
    const char* word = ""; ///< the animal that is named, English; empty: none
    float usual = 1.5F;
    float smallest = 0.1F; ///< nobody wonders about what lies between
    float largest = 12.0F;
};

/// `size`: as it stands upright, before it is scaled.
[[nodiscard]] BodyGuess guessBody(const Template& asset, const glm::vec3& size);

} // namespace crowd::model
