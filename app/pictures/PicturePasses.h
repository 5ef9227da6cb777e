// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/pictures/Cryptomatte.h"
#include "app/pictures/ExrFile.h"
#include "app/pictures/PassSamples.h"
#include "model/base/Result.h"
#include "model/scene/CrowdFrame.h"
#include "model/view/View.h"
#include "render/AovPicture.h"

namespace crowd::app {

/// What the layers of a picture are made from.
struct PassSource
{
    /// Of a deep picture, rows from the top; these and the next two: empty where no pass needs it.
    std::span<const std::uint8_t> colours;
    bool isTransparent = false;
    const render::AovPicture& aovs;
    const Coverage& coverage;
    const model::CrowdFrame& frame;
    const model::Camera& camera;
};

/// What a pass is made from.
enum class PassNeed : std::uint8_t {
    Colours,
    Aovs,    ///< of the middle of each pixel
    Motion,  ///< the same, against the moment before
    Coverage ///< all of each pixel
};

/// A pass of a picture: a layer of an OpenEXR file, or numbers for a script. The command line, the
/// window, scripts and their messages follow from the table.
struct PicturePass
{
    std::string_view key;
    const char* label;
    const char* doc; ///< what its numbers are
    PassNeed need;
    ExrLayer (*layer)(const PassSource& source);
    /// Of a PNG; null: as numbers of an OpenEXR file alone, or as the picture itself.
    PassSamples (*samples)(const ExrLayer& layer) = nullptr;
    /// Adds what the header of its file says; null: nothing.
    void (*addNotes)(const model::CrowdFrame& frame, ExrHeader& header) = nullptr;
};

using PicturePasses = std::vector<const PicturePass*>;

/// Colours first.
[[nodiscard]] std::span<const PicturePass> picturePasses();
/// "colour, depth, normal".
[[nodiscard]] std::string passKeys();
/// Of keys with commas between them, each once, in the table's order. An error names what there is.
[[nodiscard]] model::Result<PicturePasses> passesOf(std::string_view keys);
[[nodiscard]] bool needAny(const PicturePasses& passes, PassNeed need);

/// What somebody who opens the file needs to know besides.
[[nodiscard]] ExrHeader exrHeaderOf(const PicturePasses& passes, const model::Camera& camera,
                                    glm::ivec2 size, const model::CrowdFrame& frame);
[[nodiscard]] std::vector<ExrLayer> layersOf(const PicturePasses& passes, const PassSource& source);

} // namespace crowd::app
