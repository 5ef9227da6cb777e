// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/template/Template.h"
#include "render/OffscreenContext.h"
#include "render/Renderer.h"
#include "tests/render/TestScene.h"

/// Pictures of imported characters, whatever their size.
namespace crowd::testing {

struct DrawnFile
{
    std::string problem; ///< why nothing could be drawn; empty otherwise
    int coveredPixels = 0;
    std::vector<std::uint8_t> pixels; ///< RGBA8, rows from the top

    [[nodiscard]] const std::uint8_t* at(int x, int y) const;
};

class FileDrawing
{
public:
    static constexpr int kPixels = 128; ///< both sides of a picture

    FileDrawing()
    {
        qunsetenv("DISPLAY");
        qunsetenv("WAYLAND_DISPLAY");
        auto context = render::OffscreenContext::create();
        if (!context) {
            m_problem = context.error().message;
            return;
        }
        m_context = std::move(context).value();
        if (const auto ready = m_renderer.initialize(); !ready) {
            m_problem = ready.error().message;
        }
    }

    ~FileDrawing() { m_renderer.destroy(); }

    FileDrawing(const FileDrawing&) = delete;
    FileDrawing& operator=(const FileDrawing&) = delete;

    [[nodiscard]] const std::string& problem() const { return m_problem; }

    /// One individual that fills a share of the picture's height, from in front and from behind:
    /// the picture that shows more of it.
    [[nodiscard]] DrawnFile draw(const model::TemplatePtr& asset, float share)
    {
        DrawnFile best = drawFrom(asset, share, {0.5F, 0.6F, 1.0F});
        if (best.coveredPixels == 0 && best.problem.empty()) {
            best = drawFrom(asset, share, {-0.5F, -0.6F, -1.0F});
        }
        return best;
    }

    /// Before a green wall, base colours without light; `way` leads from the character to the eye.
    [[nodiscard]] DrawnFile drawFrom(const model::TemplatePtr& asset, float share,
                                     const glm::vec3& way)
    {
        const glm::vec3 size = asset->bounds.size();
        const float extent = std::max({size.x, size.y, size.z, 1e-9F});
        const float scale = 2.0F / extent;
        model::Population people = makeRow(1);
        setAll(people, model::columns::height, scale);
        setAll(people, model::columns::girth, scale);
        setAll(people, model::columns::position, -asset->bounds.center() * scale);
        setAll(people, model::columns::parts, ~0U);
        setAll(people, model::columns::clip, static_cast<std::uint16_t>(asset->defaultClip));
        return drawPeople(people, {entryFor(asset)}, 2.0F / share, way);
    }

    /// As many metres around the origin as the picture is to be high.
    [[nodiscard]] DrawnFile drawPeople(const model::Population& people,
                                       const std::vector<model::TemplateEntry>& entries,
                                       float metres, const glm::vec3& way)
    {
        render::RenderInput input = inputFor(metres, way);
        input.frame = frameOf(people, entries);
        return picture(input);
    }

    [[nodiscard]] DrawnFile drawGhost(const render::Ghost& ghost, float metres)
    {
        render::RenderInput input = inputFor(metres, {0.0F, 0.0F, 1.0F});
        input.ghosts = {&ghost, 1};
        return picture(input);
    }

private:
    [[nodiscard]] render::RenderInput inputFor(float metres, const glm::vec3& way)
    {
        model::Camera camera =
            model::Camera::lookingAt(glm::normalize(way) * 10.0F, glm::vec3(0.0F));
        camera.projection = model::Projection::Orthographic;
        camera.orthographicHeight = metres;
        render::RenderInput input({camera, glm::vec2(static_cast<float>(kPixels))}, m_keyframes);
        input.look = render::Look::Plain;
        input.showGround = false;
        input.showShadows = false;
        input.background = {0.0F, 1.0F, 0.0F, 1.0F};
        return input;
    }

    [[nodiscard]] DrawnFile picture(const render::RenderInput& input)
    {
        DrawnFile drawn;
        for (int pass = 0; pass < 2; ++pass) { // the first asks for clips, the second has them
            if (const auto done = m_renderer.draw(input); !done) {
                drawn.problem = done.error().message;
                return drawn;
            }
            m_keyframes.waitForAll();
        }
        drawn.pixels = m_renderer.readPixels();
        for (std::size_t i = 0; i < drawn.pixels.size(); i += 4) {
            const bool isWall =
                drawn.pixels[i] == 0 && drawn.pixels[i + 1] == 255 && drawn.pixels[i + 2] == 0;
            drawn.coveredPixels += isWall ? 0 : 1;
        }
        return drawn;
    }

    std::string m_problem;
    std::unique_ptr<render::OffscreenContext> m_context;
    render::Renderer m_renderer;
    model::KeyframeStore m_keyframes;
};

inline const std::uint8_t* DrawnFile::at(int x, int y) const
{
    return pixels.data() +
           (static_cast<std::size_t>(y) * FileDrawing::kPixels + static_cast<std::size_t>(x)) * 4;
}

} // namespace crowd::testing
