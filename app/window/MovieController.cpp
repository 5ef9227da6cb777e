// SPDX-License-Identifier: MIT
#include "app/window/MovieController.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include "app/pictures/MovieFile.h"
#include "app/pictures/MovieFormats.h"
#include "app/pictures/NumberedPictures.h"
#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFormats.h"
#include "app/window/AskForPath.h"
#include "app/window/MovieDialog.h"
#include "app/window/PictureJob.h"
#include "behavior/session/MotionReader.h"
#include "behavior/session/SceneMotion.h"
#include "model/base/Translated.h"
#include "model/scene/LookPreset.h"
#include "model/view/CameraTrack.h"

namespace crowd::app {

namespace {

constexpr std::size_t kMovieKeyframeBytes = std::size_t{2} << 30U;

struct MovieJob
{
    QString path;
    PictureJob picture;
    model::CameraTrack camera;
    model::Scene scene;
    model::CrowdFramePtr shown;                 ///< whom the run does not have
    std::shared_ptr<behavior::MotionCache> run; ///< null: the scene from its beginning
    TimeSpan span;
    double earliest = 0.0;   ///< seconds: nothing is known of what was before
    double posedSince = 0.0; ///< seconds: before that the run had not begun
    double framesPerSecond = 30.0;
    PicturePasses passes;
    bool isResumed = false; ///< numbered pictures that are there stay
    QString title;

    /// Else each picture is a file.
    [[nodiscard]] bool isMovie() const { return pictureFormatOf(path) == nullptr; }
    [[nodiscard]] QString fileOf(int number) const
    {
        return fileForFrame(numberedPattern(path), number);
    }

    [[nodiscard]] int pictures() const { return span.pictures(framesPerSecond); }
    [[nodiscard]] double secondsOf(int number) const
    {
        return span.from + number / framesPerSecond;
    }
};

model::Error stopped()
{
    return model::Error{QT_TRANSLATE_NOOP("Messages", "The movie was cancelled.")};
}

/// People at one time after the other.
class MovieFrames
{
public:
    explicit MovieFrames(const MovieJob& job) : m_job(job)
    {
        if (job.run) {
            m_reader = std::make_unique<behavior::MotionReader>(job.run);
        } else {
            m_motion = std::make_unique<behavior::SceneMotion>(job.scene);
        }
    }

    [[nodiscard]] model::Result<model::CrowdFramePtr> at(double seconds,
                                                         const model::KeepGoing& keepGoing)
    {
        return m_motion ? ofScene(seconds, keepGoing) : ofRun(seconds);
    }

private:
    [[nodiscard]] model::Result<model::CrowdFramePtr> ofScene(double seconds,
                                                              const model::KeepGoing& keepGoing)
    {
        std::atomic<bool> isOver{false};
        auto frame =
            m_motion->at(seconds, &isOver, [&](double) { isOver = isOver || !keepGoing(0.0); });
        if (!frame) {
            return stopped();
        }
        return frame;
    }
    [[nodiscard]] model::Result<model::CrowdFramePtr> ofRun(double seconds)
    {
        auto frame = std::make_shared<model::CrowdFrame>(*m_job.shown);
        frame->seconds = seconds;
        if (seconds < m_job.posedSince) {
            return model::CrowdFramePtr(std::move(frame));
        }
        const auto [before, after] = m_reader->around(seconds);
        if (!before) {
            return model::Error{
                QT_TRANSLATE_NOOP("Messages", "What was played at %1 s is not known any more. Play "
                                              "it again, or begin the movie later."),
                seconds};
        }
        behavior::applyPose(*before, *after, *frame);
        return model::CrowdFramePtr(std::move(frame));
    }

    const MovieJob& m_job;
    std::unique_ptr<behavior::MotionReader> m_reader;
    std::unique_ptr<behavior::SceneMotion> m_motion;
};

/// Where pictures go to, one after the other: a movie, or a file each.
class DrawnFrames
{
public:
    explicit DrawnFrames(const MovieJob& job) : m_job(job) {}

    [[nodiscard]] model::Result<void> begin()
    {
        if (!m_job.passes.empty()) {
            return roomForPasses(m_job.path, m_job.passes);
        }
        if (!m_job.isMovie()) {
            return {};
        }
        if (m_job.picture.request.isTransparent) {
            return model::Error{
                QT_TRANSLATE_NOOP("Messages", "%1: a movie cannot be transparent. Choose numbered "
                                              "pictures, or switch the transparency off."),
                m_job.path.toStdString()};
        }
        auto movie =
            MovieFile::create(m_job.path, m_job.picture.request.size, m_job.framesPerSecond);
        if (!movie) {
            return movie.error();
        }
        m_movie = std::move(movie).value();
        return {};
    }
    /// There already, from the last time.
    [[nodiscard]] bool has(int picture) const
    {
        return m_job.isResumed && !m_movie &&
               arePassesThere(m_job.fileOf(picture), m_job.passes, m_job.picture.request.size);
    }
    [[nodiscard]] model::Result<void> add(int picture, PictureMaker& maker,
                                          const PictureRequest& request,
                                          const model::KeepGoing& keepGoing)
    {
        if (!m_movie) {
            return maker.save(m_job.fileOf(picture), request, m_job.passes, keepGoing);
        }
        auto drawn = maker.draw(request, keepGoing);
        return drawn ? m_movie->add(maker.pixels()) : drawn;
    }
    [[nodiscard]] model::Result<void> finish()
    {
        return m_movie ? m_movie->finish() : model::Result<void>();
    }

private:
    const MovieJob& m_job;
    std::unique_ptr<MovieFile> m_movie;
};

/// A camera's own look comes with it, as in the view.
void lookThrough(const model::Scene& scene, const model::DirectedCamera& camera,
                 PictureJob& picture)
{
    picture.request.camera = camera.camera;
    const model::LookPreset* look = model::findLook(scene.looks, camera.look);
    if (look != nullptr) {
        picture.request.ownLook = *look;
    }
}

model::Result<void> drawMovie(const MovieJob& job, const widgets::TaskReport& report)
{
    model::KeyframeStore keyframes(kMovieKeyframeBytes);
    auto maker = PictureMaker::create(keyframes);
    if (!maker) {
        return maker.error();
    }
    DrawnFrames drawnFrames(job);
    if (auto begun = drawnFrames.begin(); !begun) {
        return begun;
    }
    MovieFrames frames(job);
    PictureJob picture = job.picture;
    const int pictures = job.pictures();
    for (int i = 0; i < pictures; ++i) {
        if (drawnFrames.has(i)) {
            continue;
        }
        const float share = static_cast<float>(i) / static_cast<float>(pictures);
        const auto keepGoing = [&](double) { return report(job.title, share); };
        picture.request.earlier.reset();
        if (needAny(job.passes, PassNeed::Motion)) {
            const double before = std::max(job.secondsOf(i - 1), job.earliest);
            const auto frame = frames.at(before, keepGoing);
            if (!frame) {
                return frame.error();
            }
            picture.request.earlier = render::EarlierMoment{
                frame.value(), job.camera.before(before, job.secondsOf(i)).camera};
        }
        const auto frame = frames.at(job.secondsOf(i), keepGoing);
        if (!frame) {
            return frame.error();
        }
        if (!keepGoing(0.0)) {
            return stopped();
        }
        picture.request.ownLook = job.picture.request.ownLook;
        lookThrough(job.scene, job.camera.at(job.secondsOf(i)), picture);
        const PictureRequest& request = picture.ask(job.scene, frame.value());
        if (auto added = drawnFrames.add(i, *maker.value(), request, keepGoing); !added) {
            return added;
        }
    }
    return drawnFrames.finish();
}

/// That can be what was chosen.
std::vector<SaveKind> movieKinds(bool hasPasses, bool isTransparent)
{
    std::vector<SaveKind> kinds;
    for (const MovieFormat& format : movieFormats()) {
        if (!hasPasses && !isTransparent) {
            kinds.push_back({QLatin1String(format.name), {QLatin1String(format.ending)}});
        }
    }
    for (const PictureFormat& format : pictureFormats()) {
        if ((hasPasses && format.passes == PassRoom::None) ||
            (isTransparent && !format.hasTransparency)) {
            continue;
        }
        SaveKind& kind = kinds.emplace_back();
        kind.name = MovieController::tr("Numbered pictures, %1").arg(QLatin1String(format.name));
        for (const char* ending : format.endings) {
            kind.endings << QLatin1String(ending);
        }
    }
    return kinds;
}

/// Of those that would be drawn.
int countThere(const MovieJob& job)
{
    int there = 0;
    for (int i = 0; i < job.pictures() && !job.isMovie(); ++i) {
        there += QFileInfo::exists(job.fileOf(i)) ? 1 : 0;
    }
    return there;
}

/// A movie's camera by what was chosen.
model::CameraTrack trackOf(const MovieCamera& chosen, const MovieJob& job,
                           const model::Camera& view)
{
    using Kind = MovieCamera::Kind;
    const auto index = static_cast<std::size_t>(std::max(chosen.index, 0));
    if (chosen.kind == Kind::Timeline) {
        return model::CameraTrack(job.scene);
    }
    if (chosen.kind == Kind::Scene && index < job.scene.cameras.size()) {
        return model::CameraTrack(model::directed(job.scene.cameras[index]));
    }
    const model::DirectedCamera start{view, {}, 0};
    if (chosen.kind == Kind::Turntable) {
        return model::CameraTrack::turntable(start, job.span.from,
                                             job.pictures() / job.framesPerSecond);
    }
    return model::CameraTrack(start);
}

} // namespace

MovieController::MovieController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window),
      m_task(window, [&state] { return !state.document().isEditOpen(); })
{
}

void MovieController::make(glm::ivec2 view)
{
    if (m_task.isRunning()) {
        m_state.showStatus(tr("Another movie is still being made."));
        return;
    }
    const widgets::SessionControl& session = m_state.session();
    MovieDialog::Offer offer;
    offer.view = view;
    for (const model::NamedCamera& camera : m_state.scene().cameras) {
        offer.cameras << QString::fromStdString(camera.name);
    }
    if (session.isPosed() && session.liveSeconds() > session.firstSeconds()) {
        offer.run = TimeSpan{session.firstSeconds(), session.liveSeconds()};
    }
    offer.hasMoves = m_state.director().track().hasMoves();
    for (const model::Mark& mark : m_state.scene().timeline) {
        offer.lastMark = std::max(offer.lastMark, mark.seconds + mark.length());
    }
    if (const model::PlayRange& range = m_state.scene().playRange; range.isSet()) {
        offer.range = TimeSpan{range.begin, range.end};
    }
    MovieDialog dialog(offer, m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const QString path = askForPath(
        m_window, tr("Make Movie"), movieKinds(!dialog.passes().empty(), dialog.isTransparent()),
        QStringLiteral("movie/folder"), m_state.document().path(),
        QStandardPaths::writableLocation(QStandardPaths::MoviesLocation), tr("movie"));
    if (!path.isEmpty()) {
        draw(path, dialog);
    }
}

bool MovieController::askOfThose(int there, bool& areKept)
{
    QMessageBox box(QMessageBox::Question, tr("Make Movie"),
                    tr("%n of the pictures are there already.", nullptr, there),
                    QMessageBox::Cancel, m_window);
    box.setObjectName(QStringLiteral("picturesAreThere"));
    QPushButton* missing = box.addButton(tr("Draw What Is Missing"), QMessageBox::AcceptRole);
    missing->setObjectName(QStringLiteral("drawMissing"));
    QPushButton* all = box.addButton(tr("Draw All Anew"), QMessageBox::DestructiveRole);
    all->setObjectName(QStringLiteral("drawAll"));
    box.setDefaultButton(missing);
    box.exec();
    areKept = box.clickedButton() == missing;
    return areKept || box.clickedButton() == all;
}

void MovieController::draw(const QString& path, const MovieDialog& chosen)
{
    MovieJob job;
    job.path = path;
    job.picture = PictureJob::ofView(m_state);
    job.scene = m_state.scene();
    job.span = chosen.span();
    job.framesPerSecond = chosen.framesPerSecond();
    job.passes = chosen.passes();
    job.title = tr("Drawing %1").arg(QFileInfo(path).fileName());
    job.camera = trackOf(chosen.camera(), job, m_state.camera());
    job.picture.request.size = chosen.chosenSize();
    job.picture.request.isTransparent = chosen.isTransparent();
    if (chosen.isOfRun()) {
        // A take is seen as the scene shows it, with what was done to people by hand.
        job.run = m_state.session().take() == 0 ? m_state.session().motion() : nullptr;
        job.earliest = m_state.session().firstSeconds();
        job.posedSince = m_state.session().posedSince();
        job.shown = m_state.document().frame(job.span.from);
    }
    if (const int there = countThere(job); there > 0 && !askOfThose(there, job.isResumed)) {
        return;
    }
    m_task.start(
        tr("Making the movie…"),
        [job = std::move(job)](const widgets::TaskReport& report) {
            return drawMovie(job, report);
        },
        [this, path](const model::Result<void>& made) {
            if (made) {
                Q_EMIT ended(tr("Made %1").arg(QDir::toNativeSeparators(path)));
                return;
            }
            QMessageBox::warning(m_window, tr("The movie could not be made"),
                                 model::translated(made.error()));
        });
}

} // namespace crowd::app
