// SPDX-License-Identifier: MIT
#include "render/Renderer.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <epoxy/gl.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/gl/Blending.h"
#include "render/gl/CardMemory.h"
#include "render/gl/SoftwareTuning.h"
#include "render/passes/Passes.h"

namespace crowd::render {

namespace {

constexpr int kLeastVersion = 33;

void beginState(bool isTransparent)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glStencilMask(0xFFU);
    glDisable(GL_BLEND);
    blendOver(isTransparent);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void endState()
{
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

/// The n-th number of a sequence that fills 0..1 evenly, however many are taken (J. H. Halton,
/// 1960).
float halton(int n, int base)
{
    float sum = 0.0F;
    float share = 1.0F;
    for (int rest = n; rest > 0; rest /= base) {
        share /= static_cast<float>(base);
        sum += share * static_cast<float>(rest % base);
    }
    return sum;
}

/// Through the n-th place of the lens, so that what is in focus stays where it is. The places fill
/// a disc evenly, however many are taken (M. Roberts, 2018).
glm::mat4 throughLens(const model::View& view, const Lens& lens, int n)
{
    const double count = n;
    const auto share = static_cast<float>(std::fmod(0.5 + count * 0.7548776662466927, 1.0));
    const auto turn =
        static_cast<float>(std::fmod(count * 0.5698402909980532, 1.0)) * glm::two_pi<float>();
    const glm::vec2 place =
        lens.radiusMetres * std::sqrt(share) * glm::vec2(std::cos(turn), std::sin(turn));
    const glm::mat4& projection = view.projectionMatrix();
    const glm::vec2 shift =
        place * glm::vec2(projection[0][0], projection[1][1]) / lens.focusMetres;
    return glm::translate(glm::mat4(1.0F), {shift.x, shift.y, 0.0F}) * projection *
           glm::translate(glm::mat4(1.0F), {-place.x, -place.y, 0.0F}) * view.viewMatrix();
}

/// Of a picture that ripens, through another part of the pixels and of the lens each time; without
/// a lens the first as it is.
glm::mat4 shiftedViewProjection(const RenderInput& input, glm::ivec2 size)
{
    if (!input.ripeness) {
        return input.view.viewProjection();
    }
    const int n = *input.ripeness;
    const bool hasLens =
        input.lens && input.view.camera().projection == model::Projection::Perspective;
    const glm::mat4 seen =
        hasLens ? throughLens(input.view, *input.lens, n) : input.view.viewProjection();
    if (n == 0) {
        return seen;
    }
    const glm::vec2 part(halton(n, 2) - 0.5F, halton(n, 3) - 0.5F);
    const glm::vec2 clip = 2.0F * part / glm::vec2(size);
    return glm::translate(glm::mat4(1.0F), {clip.x, clip.y, 0.0F}) * seen;
}

} // namespace

struct Renderer::Private
{
    std::unique_ptr<Passes> passes;
    bool isSoftware = false;
    bool isFullAgain = false; ///< there may be room again for what was reduced
    RenderStatistics statistics;

    /// Everything anew, and sent again with the next picture.
    [[nodiscard]] model::Result<void> begin(int reduction);
    /// Draws; what the card has no room for is sent and drawn once more, coarser.
    template<class Draw>
    [[nodiscard]] auto fitting(const Draw& draw) -> decltype(draw());
    [[nodiscard]] model::Result<void> draw(const RenderInput& input, const std::uint32_t* target);
    [[nodiscard]] model::Result<void> drawOnce(const RenderInput& input,
                                               const std::uint32_t* target);
    [[nodiscard]] model::Result<AovPicture> drawAovs(const RenderInput& input);
    [[nodiscard]] PassContext contextOf(const RenderInput& input, Style style);
};

Renderer::Renderer() : m_private(std::make_unique<Private>()) {}

Renderer::~Renderer()
{
    abandon();
}

model::Result<void> Renderer::initialize()
{
    const int version = epoxy_gl_version();
    if (!epoxy_is_desktop_gl() || version < kLeastVersion) {
        const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        return model::Error{
            QT_TRANSLATE_NOOP("Messages",
                              "Drawing needs OpenGL 3.3; this context offers %1. Install a newer "
                              "graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1."),
            text != nullptr ? model::Message(std::string(text))
                            : model::Message(QT_TRANSLATE_NOOP("Messages", "nothing"))};
    }
    m_private->isSoftware = isSoftwareRenderer();
    if (m_private->isSoftware) {
        tuneForSoftwareRendering();
    }
    return m_private->begin(0);
}

model::Result<void> Renderer::Private::begin(int reduction)
{
    passes.reset(); // the new ones may need its room
    auto begun = std::make_unique<Passes>(reduction);
    if (auto ready = begun->initialize(); !ready) {
        return ready;
    }
    passes = std::move(begun);
    return {};
}

template<class Draw>
auto Renderer::Private::fitting(const Draw& draw) -> decltype(draw())
{
    const bool isReduced = passes && passes->reduction > 0;
    if (!passes || (std::exchange(isFullAgain, false) && isReduced)) {
        if (auto begun = begin(0); !begun) {
            return begun.error();
        }
    }
    for (;;) {
        auto drawn = draw();
        if (!card_memory::wasShort()) {
            return drawn;
        }
        if (passes->reduction == kMostReduction) {
            return model::Error{QT_TRANSLATE_NOOP(
                "Messages", "The memory of the graphics card does not suffice for this picture, "
                            "however coarse. Choose a smaller picture, remove templates from the "
                            "scene, or close other programs.")};
        }
        if (auto begun = begin(passes->reduction + 1); !begun) {
            return begun.error();
        }
    }
}

bool Renderer::isInitialized() const
{
    return m_private->passes != nullptr;
}

void Renderer::destroy()
{
    m_private->passes.reset();
}

void Renderer::abandon()
{
    const ContextLostScope lost;
    m_private->passes.reset();
}

void Renderer::releaseUnused()
{
    m_private->isFullAgain = true;
    if (m_private->passes) {
        m_private->passes->crowd.releaseUnused();
        m_private->passes->stage.releaseUnused();
    }
}

PassContext Renderer::Private::contextOf(const RenderInput& input, Style style)
{
    statistics = {};
    statistics.reduction = passes->reduction;
    const glm::ivec2 size =
        input.pixelSize.x > 0 ? input.pixelSize : glm::ivec2(input.view.size() + 0.5F);
    return {input,
            shiftedViewProjection(input, size),
            std::move(style),
            size,
            passes->reduction,
            isSoftware,
            statistics};
}

model::Result<void> Renderer::Private::drawOnce(const RenderInput& input,
                                                const std::uint32_t* target)
{
    const auto start = std::chrono::steady_clock::now();
    const PassContext context = contextOf(input, Style::of(input));
    const PixelKind kind = input.isDeep ? PixelKind::Halves : PixelKind::Bytes;
    const int samples = passes->reduction > 0 ? 0 : input.samples;
    if (auto begun = passes->target.begin(context.pixelSize, samples, kind); !begun) {
        return begun;
    }
    beginState(input.isTransparent);
    auto drawn = passes->draw(context);
    auto finished = passes->finish(context, target);
    drawn = drawn ? finished : drawn;
    endState();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    statistics.totalMs = spent.count();
    statistics.submitMs = spent.count() - statistics.recordsMs - statistics.planMs;
    return drawn;
}

model::Result<void> Renderer::Private::draw(const RenderInput& input, const std::uint32_t* target)
{
    auto drawn = fitting([&] { return drawOnce(input, target); });
    statistics.cardBytes = card_memory::bytes();
    return drawn;
}

model::Result<void> Renderer::draw(const RenderInput& input, std::uint32_t framebuffer)
{
    return m_private->draw(input, &framebuffer);
}

model::Result<void> Renderer::draw(const RenderInput& input)
{
    return m_private->draw(input, nullptr);
}

model::Result<AovPicture> Renderer::Private::drawAovs(const RenderInput& input)
{
    const PassContext context = contextOf(input, Style::ofAovs(input));
    beginState(false);
    glDisable(GL_FRAMEBUFFER_SRGB);
    auto drawn = passes->drawAovs(context);
    endState();
    return drawn;
}

model::Result<AovPicture> Renderer::drawAovs(const RenderInput& input)
{
    return m_private->fitting([&] { return m_private->drawAovs(input); });
}

std::vector<std::uint8_t> Renderer::readPixels() const
{
    return m_private->passes->target.read();
}

glm::ivec2 Renderer::size() const
{
    return m_private->passes->target.size();
}

const RenderStatistics& Renderer::statistics() const
{
    return m_private->statistics;
}

} // namespace crowd::render
