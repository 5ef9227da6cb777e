// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>

#include <QtTest/QTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "behavior/session/Session.h"
#include "model/bake/ClipBaker.h"
#include "model/bake/KeyframeTime.h"
#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"

using namespace crowd;

/// Whether feet that touch the ground stay where they are, seen as the renderer shows them: baked
/// keyframes, two at a time, cross-faded, at the places and playback rates of a session.
class FootSlideTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void feetStay_data();
    void feetStay();
    void restsWhereThePathEnds_data();
    void restsWhereThePathEnds();
};

namespace {

constexpr double kSample = 1.0 / 120.0;
constexpr float kSole = 0.05F;     ///< vertices lower than this when standing are soles, metres
constexpr float kContact = 0.002F; ///< a sole lower than this bears weight

/// What may be seen. While nothing changes feet stand still but for what lies between keyframes. A
/// change of clips takes a quarter of a second, in which a foot may go a third of its length.
/// Somebody who turns pivots on a foot that turns with him.
constexpr double kStill = 0.005;
constexpr double kChange = 0.1;
constexpr double kAroundCorner = 0.2;

/// Left and right sole of one person through time.
class Feet
{
public:
    explicit Feet(model::TemplatePtr asset) : m_asset(std::move(asset))
    {
        const std::vector<glm::vec3> rest =
            model::exactKeyframe(*m_asset, m_asset->defaultClip, 0).positions;
        for (std::size_t v = 0; v < rest.size(); ++v) {
            if (rest[v].y < kSole) {
                m_soles[rest[v].x > 0.0F ? 0 : 1].push_back(v);
            }
        }
    }

    /// Where the soles of somebody are: one list a foot, world frame.
    using Places = std::array<std::vector<glm::vec3>, 2>;
    Places at(const model::CrowdFrame& frame, std::size_t row)
    {
        namespace keys = model::columns;
        const model::Population& people = frame.population;
        const auto shown = [&](std::size_t clip, float phase) {
            return std::pair(clip, model::keyframePlace(m_asset->clips[clip], phase));
        };
        const std::size_t clip = people.column(keys::clip)[row];
        const auto now =
            shown(clip, model::shownPhase(m_asset->clips[clip], people.column(keys::phase)[row],
                                          people.column(keys::playbackSpeed)[row], frame.seconds));
        const auto fade = std::ranges::find(frame.fades, row, &model::ClipFade::row);
        const float heading = people.column(keys::heading)[row];
        const glm::vec3 foot = people.column(keys::position)[row];
        Places places;
        for (std::size_t side = 0; side < 2; ++side) {
            for (const std::size_t v : m_soles[side]) {
                glm::vec3 p = vertex(now, v);
                if (fade != frame.fades.end()) {
                    p = glm::mix(vertex(shown(fade->clip, fade->place), v), p, fade->share);
                }
                p *= people.column(keys::height)[row];
                places[side].push_back(
                    foot + glm::vec3(p.x * std::cos(heading) + p.z * std::sin(heading), p.y,
                                     p.z * std::cos(heading) - p.x * std::sin(heading)));
            }
        }
        return places;
    }

private:
    glm::vec3 vertex(const std::pair<std::size_t, model::KeyframePlace>& shown, std::size_t v)
    {
        auto& baked = m_baked[shown.first];
        if (!baked) {
            baked = model::bakeClip(*m_asset, static_cast<int>(shown.first),
                                    m_asset->clips[shown.first].keyframeCount());
        }
        return glm::mix(baked->position(0, shown.second.first, v),
                        baked->position(0, shown.second.second, v), shown.second.blend);
    }

    model::TemplatePtr m_asset;
    std::array<std::vector<std::size_t>, 2> m_soles;
    std::map<std::size_t, model::BakedClipPtr> m_baked;
};

/// How far a foot goes along the ground while the same sole touches it: that of its points that
/// touches before and after and moves the least, since a foot rolls from heel to toe.
double slideOf(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& after)
{
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].y < kContact && after[i].y < kContact) {
            const glm::vec3 way = after[i] - before[i];
            least = std::min(least, std::hypot(way.x, way.z));
        }
    }
    return least < 1.0F ? static_cast<double>(least) : -1.0;
}

/// Slide of both feet over a time. The first and the last moments of a contact are landing and
/// lifting: the sole is down there already, or still, while the foot swings.
class Slide
{
public:
    void add(const Feet::Places& before, const Feet::Places& after)
    {
        for (std::size_t side = 0; side < 2; ++side) {
            const double slide = slideOf(before[side], after[side]);
            if (slide >= 0.0) {
                m_contact[side].push_back(slide);
            } else {
                lift(side);
            }
        }
    }
    void finish()
    {
        lift(0);
        lift(1);
    }
    [[nodiscard]] double worstStance() const { return m_worstStance; } ///< metres, of one foot
    [[nodiscard]] double total() const { return m_total; }

private:
    static constexpr std::ptrdiff_t kLanding = 8; ///< samples: a fifteenth of a second

    void lift(std::size_t side)
    {
        std::vector<double>& contact = m_contact[side];
        if (std::ssize(contact) > 2 * kLanding) {
            const double slide =
                std::accumulate(contact.begin() + kLanding, contact.end() - kLanding, 0.0);
            m_worstStance = std::max(m_worstStance, slide);
            m_total += slide;
        }
        contact.clear();
    }

    std::array<std::vector<double>, 2> m_contact;
    double m_worstStance = 0.0;
    double m_total = 0.0;
};

constexpr float kWalk = 1.24F;
constexpr float kRun = 2.9F;

/// A man alone on a straight path, or round a corner after 6 m.
model::Scene walkerScene(const model::TemplatePtr& asset, float speed, bool hasCorner, float length)
{
    model::Scene scene;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.name = "man";
    entry.asset = asset;
    for (const model::Clip& clip : asset->clips) {
        entry.clipNames.push_back(clip.name);
    }
    scene.templates.push_back(entry);
    const std::vector<model::IndividualId> ids{1};
    auto rows = model::IndividualRows::withDefaults(ids);
    rows.column(model::columns::templateId)[0] = 1;
    rows.column(model::columns::clip)[0] = static_cast<std::uint16_t>(asset->defaultClip);
    rows.column(model::columns::path)[0] = 1;
    rows.column(model::columns::walkSpeed)[0] = speed;
    scene.population.add(rows);
    scene.places = {{1, "bend", {0.0F, 0.0F, hasCorner ? 6.0F : length}, 0.0F},
                    {2, "end", {hasCorner ? length : 0.0F, 0.0F, hasCorner ? 6.0F : length}, 0.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    return scene;
}

} // namespace

void FootSlideTest::feetStay_data()
{
    QTest::addColumn<float>("speed");
    QTest::addColumn<float>("laterSpeed"); ///< from 4 s on
    QTest::addColumn<bool>("hasCorner");
    QTest::addColumn<float>("length");
    QTest::addColumn<double>("from"); ///< seconds
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("mostOfStance"); ///< metres
    QTest::newRow("walking") << kWalk << kWalk << false << 30.0F << 3.0 << 7.0 << kStill;
    QTest::newRow("walking slowly") << 0.8F << 0.8F << false << 30.0F << 3.0 << 7.0 << kStill;
    QTest::newRow("running") << kRun << kRun << false << 60.0F << 3.0 << 7.0 << kStill;
    QTest::newRow("setting off") << kWalk << kWalk << false << 30.0F << 0.0 << 2.0 << kChange;
    QTest::newRow("speeding up to a run")
        << kWalk << kRun << false << 60.0F << 4.0 << 7.0 << kChange;
    QTest::newRow("slowing down from it")
        << kRun << kWalk << false << 60.0F << 4.0 << 7.0 << kChange;
    for (const float length : {6.0F, 6.15F, 6.3F, 6.45F, 6.6F}) {
        QTest::addRow("stopping after %.2f m", static_cast<double>(length))
            << kWalk << kWalk << false << length << 3.0 << 9.0 << kChange;
    }
    QTest::newRow("stopping from a run") << kRun << kRun << false << 15.0F << 3.0 << 9.0 << kChange;
    QTest::newRow("round a corner")
        << kWalk << kWalk << true << 20.0F << 3.0 << 8.0 << kAroundCorner;
}

void FootSlideTest::feetStay()
{
    QFETCH(const float, speed);
    QFETCH(const float, laterSpeed);
    QFETCH(const bool, hasCorner);
    QFETCH(const float, length);
    QFETCH(const double, from);
    QFETCH(const double, to);
    QFETCH(const double, mostOfStance);
    const auto asset = model::importTemplate(CROWD_RESOURCES "/templates/man.glb");
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    model::Scene scene = walkerScene(asset.value(), speed, hasCorner, length);
    behavior::Session session(scene);
    Feet feet(asset.value());
    Slide slide;
    std::optional<Feet::Places> last;
    behavior::SessionPosePtr before = session.pose();
    behavior::SessionPosePtr after = before;
    const auto templates =
        std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates);
    bool hasChanged = false;
    for (int sample = 0; sample * kSample < to; ++sample) {
        const double seconds = sample * kSample;
        if (!hasChanged && seconds >= 4.0) {
            const std::vector<model::IndividualId> ids{1};
            scene.population.setValues<float>(model::columns::walkSpeed, ids,
                                              std::vector<float>{laterSpeed});
            session.adopt(scene, true);
            hasChanged = true;
        }
        while (after->seconds < seconds - 1e-9) {
            session.step();
            before = std::exchange(after, session.pose());
        }
        model::CrowdFrame frame{scene.population, templates, seconds};
        behavior::applyPose(*before, *after, frame);
        Feet::Places now = feet.at(frame, 0);
        if (seconds >= from && last) {
            slide.add(*last, now);
        }
        last = std::move(now);
    }
    slide.finish();
    std::printf("%-24s%6.1f mm in the worst stance (at most %.1f), %6.1f mm in all\n",
                QTest::currentDataTag(), slide.worstStance() * 1000.0, mostOfStance * 1000.0,
                slide.total() * 1000.0);
    QVERIFY2(slide.worstStance() <= mostOfStance, QByteArray::number(slide.worstStance()));
}

void FootSlideTest::restsWhereThePathEnds_data()
{
    QTest::addColumn<float>("speed");
    QTest::addColumn<double>("most"); ///< metres: feet decide where one can stop
    QTest::newRow("walking") << kWalk << 0.45;
    QTest::newRow("running") << kRun << 0.6;
}

void FootSlideTest::restsWhereThePathEnds()
{
    QFETCH(const float, speed);
    QFETCH(const double, most);
    const auto asset = model::importTemplate(CROWD_RESOURCES "/templates/man.glb");
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    double beyond = 0.0;
    double before = 0.0;
    for (float length = 10.0F; length < 11.2F; length += 0.1F) {
        model::Scene scene = walkerScene(asset.value(), speed, false, length);
        scene.paths.front().places = {1};
        behavior::Session session(scene);
        for (int i = 0; i < 450; ++i) {
            session.step();
        }
        const behavior::SessionPosePtr pose = session.pose();
        const double rest = static_cast<double>(pose->z.front() - length);
        beyond = std::max(beyond, rest);
        before = std::max(before, -rest);
    }
    std::printf("%s: at most %.2f m before the end and %.2f m beyond it\n", QTest::currentDataTag(),
                before, beyond);
    QVERIFY2(beyond <= most, QByteArray::number(beyond));
    QVERIFY2(before <= most, QByteArray::number(before));
}

CROWD_TEST(FootSlideTest)
#include "tst_FootSlide.moc"
