// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "tests/render/TestScene.h"

namespace crowd::testing {

inline constexpr int kPixels = 128; ///< of a picture from above
inline constexpr float kPerMetre = 16.0F;

/// From above, eight metres wide, X to the right and Z down.
inline model::View above()
{
    model::Camera camera = model::Camera::lookingAt({0.0F, 10.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    camera.projection = model::Projection::Orthographic;
    camera.orthographicHeight = static_cast<float>(kPixels) / kPerMetre;
    return {camera, glm::vec2(kPixels)};
}

/// What tests of pictures share: a renderer without a window, the box man, and the last picture.
class PictureBench : public QObject
{
protected:
    void open()
    {
        qunsetenv("DISPLAY");
        qunsetenv("WAYLAND_DISPLAY");
        auto context = render::OffscreenContext::create();
        QVERIFY2(context.isOk(), context ? "" : context.error().message.c_str());
        m_context = std::move(context).value();
        m_renderer = std::make_unique<render::Renderer>();
        const auto ready = m_renderer->initialize();
        QVERIFY2(ready.isOk(), ready ? "" : ready.error().message.c_str());
        m_keyframes = std::make_unique<model::KeyframeStore>();
        m_man = makeBoxMan();
    }
    void draw(const render::RenderInput& input)
    {
        for (int pass = 0; pass < 2; ++pass) { // the first asks for clips, the second has them
            const auto drawn = m_renderer->draw(input);
            QVERIFY2(drawn.isOk(), drawn ? "" : drawn.error().message.c_str());
            m_keyframes->waitForAll();
        }
        m_pixels = m_renderer->readPixels();
    }

    std::unique_ptr<render::OffscreenContext> m_context;
    std::unique_ptr<render::Renderer> m_renderer;
    std::unique_ptr<model::KeyframeStore> m_keyframes;
    model::TemplatePtr m_man;
    std::vector<std::uint8_t> m_pixels; ///< RGBA8, rows from the top
};

} // namespace crowd::testing
