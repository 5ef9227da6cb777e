// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/pictures/ExrFile.h"
#include "model/scene/CrowdFrame.h"
#include "render/AovPicture.h"

/// Mattes of every individual and of every template, with smooth edges, as compositing programs
/// pick them with one click: J. Friedman and A. Jones, Fully automatic ID mattes with support for
/// motion blur and transparency, 2015; and the specification of Cryptomatte, 1.2.0.
namespace crowd::app {

/// So many pictures, each through another part of the pixels, say how much of a pixel is whose.
inline constexpr int kCoverageSamples = 16;

/// Collects who is seen in each pixel, and of which templates they are.
class Coverage
{
public:
    /// All of the same size, of the same frame.
    void add(const render::AovPicture& picture, const model::CrowdFrame& frame);
    [[nodiscard]] int samples() const { return m_samples; }

    /// So many of one pixel at most: the rest is lost.
    static constexpr std::size_t kRanks = 6;
    struct Share
    {
        std::uint32_t key = 0;     ///< a row of the population, or a template's id
        std::uint32_t samples = 0; ///< 0: none, nor behind it
    };
    using Pixel = std::array<Share, kRanks>;
    using Pixels = std::vector<Pixel>;
    [[nodiscard]] const Pixels& individuals() const { return m_individuals; }
    [[nodiscard]] const Pixels& templates() const { return m_templates; }

private:
    Pixels m_individuals;
    Pixels m_templates;
    int m_samples = 0;
};

/// A layer of all channels of both mattes.
[[nodiscard]] ExrLayer cryptomatteLayer(const Coverage& coverage, const model::CrowdFrame& frame);
/// What the header of a file with that layer says: names, and their numbers.
void addCryptomatteNotes(const model::CrowdFrame& frame, ExrHeader& header);

/// The number that a name has in mattes: MurmurHash3 of 32 bits by A. Appleby, with seed 0, without
/// those that are no ordinary floats.
[[nodiscard]] std::uint32_t matteNumber(const std::string& name);

} // namespace crowd::app
