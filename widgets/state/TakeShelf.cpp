// SPDX-License-Identifier: MIT
#include "widgets/state/TakeShelf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "behavior/agents/AgentColumns.h"
#include "behavior/takes/RetakeKeeping.h"
#include "behavior/takes/TakeFile.h"
#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/project/TakeFiles.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/SessionControl.h"

namespace crowd::widgets {

namespace {

constexpr float kElsewhere = 0.02F; ///< metres: what is nearer nobody sees
constexpr float kTurned = 0.1F;     ///< radians

/// Not hidden, and has not left.
bool isThere(const glm::vec3& place)
{
    return place.y > 0.5F * behavior::kGoneHeight;
}

} // namespace

TakeDifference differenceOf(const model::CrowdFrame& shown, const model::CrowdFrame& other)
{
    namespace keys = model::columns;
    TakeDifference difference;
    if (shown.population.size() != other.population.size()) {
        return difference;
    }
    const auto here = shown.population.column(keys::position);
    const auto there = other.population.column(keys::position);
    const auto looks = shown.population.column(keys::heading);
    const auto looked = other.population.column(keys::heading);
    const auto clips = shown.population.column(keys::clip);
    const auto clipsThere = other.population.column(keys::clip);
    difference.people = here.size();
    double sum = 0.0;
    for (std::size_t row = 0; row < here.size(); ++row) {
        const bool isHere = isThere(here[row]);
        if (isHere != isThere(there[row])) {
            difference.extra += isHere ? 1U : 0U;
            if (!isHere) {
                difference.absent.push_back(row);
            }
            continue;
        }
        const float metres = glm::distance(here[row], there[row]);
        const bool isTurned = std::abs(std::sin((looks[row] - looked[row]) * 0.5F)) > kTurned;
        if (metres <= kElsewhere && !isTurned && clips[row] == clipsThere[row]) {
            continue;
        }
        difference.rows.push_back(row);
        sum += static_cast<double>(metres);
        difference.most = std::max(difference.most, metres);
    }
    if (!difference.rows.empty()) {
        difference.mean = static_cast<float>(sum / static_cast<double>(difference.rows.size()));
    }
    return difference;
}

QString freeTakeName(const model::Scene& scene)
{
    for (std::size_t number = scene.takes.size() + 1;; ++number) {
        QString name = TakeShelf::tr("Take %1").arg(number);
        if (std::ranges::none_of(scene.takes, [text = name.toStdString()](const model::Take& each) {
                return each.name == text;
            })) {
            return name;
        }
    }
}

TakeShelf::TakeShelf(model::SceneDocument& document, SessionControl& session, QObject* parent)
    : QObject(parent), m_document(document), m_session(session),
      m_task([&document] { return !document.isEditOpen(); })
{
    connect(&document, &model::SceneDocument::changed, this, &TakeShelf::followScene);
    connect(&m_task, &BackgroundTask::progressed, this, [this](const QString&, float share) {
        m_share = share;
        Q_EMIT keeping();
    });
    connect(&m_task, &BackgroundTask::ended, this, [this] {
        m_share = -1.0F;
        Q_EMIT keeping();
    });
}

bool TakeShelf::keep(const QString& name)
{
    const auto motion = m_session.motion();
    if (!motion || motion->extent().steps == 0 || m_task.isRunning()) {
        return false;
    }
    m_name = name;
    m_share = 0.0F;
    m_task.start(
        [motion, folder = folder()](const TaskReport& report) {
            return behavior::writeTake(*motion, folder, [&report](double share) {
                return report(QString(), static_cast<float>(share));
            });
        },
        [this](const model::Result<model::Take>& taken) {
            if (!taken) {
                Q_EMIT failed(model::translated(taken.error().said));
            } else if (add(taken.value(), tr("Keep take \"%1\"").arg(m_name), false)) {
                Q_EMIT kept(m_name);
            }
        });
    Q_EMIT keeping();
    return true;
}

bool TakeShelf::retake(std::vector<model::IndividualId> ids, double begin, double end,
                       bool isDifferent)
{
    const model::Take* shown = model::findTake(m_document.scene().takes, m_session.take());
    if (shown == nullptr || m_task.isRunning()) {
        return false;
    }
    m_name = freeTakeName(m_document.scene());
    m_share = 0.0F;
    m_task.start(
        [scene = m_document.scene(), take = *shown, motion = m_session.motion(),
         order = behavior::RetakeOrder{std::move(ids), begin, end, isDifferent},
         surface = m_session.surface(), folder = folder()](const TaskReport& report) {
            return behavior::keepRetake(
                scene, take, motion, order, surface, folder,
                [&report](double share) { return report(QString(), static_cast<float>(share)); });
        },
        [this](const model::Result<behavior::KeptRetake>& made) {
            if (!made) {
                Q_EMIT failed(model::translated(made.error().said));
                return;
            }
            const auto people = static_cast<int>(made.value().people);
            if (add(made.value().take, tr("Retake %n character(s)", nullptr, people), true)) {
                Q_EMIT retaken(m_name, people, static_cast<double>(made.value().furthestFromHome));
            }
        });
    Q_EMIT keeping();
    return true;
}

QString TakeShelf::folder() const
{
    return model::newTakesFolder(m_document.path());
}

void TakeShelf::cancel()
{
    m_task.cancel();
}

void TakeShelf::edit(const QString& text, const std::function<void(model::Takes& takes)>& change)
{
    model::Takes takes = m_document.scene().takes;
    change(takes);
    m_document.edit(
        text, [&](model::SceneEdit& edit) { edit.set<model::members::Takes>(std::move(takes)); });
}

/// False: there is no room for more, which is said.
bool TakeShelf::add(model::Take take, const QString& text, bool isShown)
{
    take.id = model::freeTakeId(m_document.scene().takes);
    take.name = m_name.toStdString();
    if (take.id == 0) {
        Q_EMIT failed(tr("There are as many takes as there can be. Delete some first."));
        return false;
    }
    edit(text, [&take, isShown](model::Takes& takes) {
        for (model::Take& each : takes) {
            each.isShown = each.isShown && !isShown;
        }
        take.isShown = isShown;
        takes.push_back(std::move(take));
    });
    return true;
}

void TakeShelf::show(model::TakeId id)
{
    const model::Take* take = model::findTake(m_document.scene().takes, id);
    const model::Take* shown = model::shownTake(m_document.scene().takes);
    if (take == shown || (id != 0 && take == nullptr)) {
        return;
    }
    edit(take != nullptr ? tr("Show take \"%1\"").arg(QString::fromStdString(take->name))
                         : tr("Play the scene instead of a take"),
         [id](model::Takes& takes) {
             for (model::Take& each : takes) {
                 each.isShown = each.id == id;
             }
         });
}

void TakeShelf::remove(model::TakeId id)
{
    if (const model::Take* take = model::findTake(m_document.scene().takes, id)) {
        edit(tr("Delete take \"%1\"").arg(QString::fromStdString(take->name)),
             [id](model::Takes& takes) {
                 std::erase_if(takes, [id](const model::Take& each) { return each.id == id; });
             });
    }
}

void TakeShelf::rename(model::TakeId id, const QString& name)
{
    const model::Take* take = model::findTake(m_document.scene().takes, id);
    if (take == nullptr || name.trimmed().isEmpty() || take->name == name.trimmed().toStdString()) {
        return;
    }
    if (std::ranges::find(m_document.scene().takes, name.trimmed().toStdString(),
                          &model::Take::name) != m_document.scene().takes.end()) {
        Q_EMIT failed(tr("Another take is called \"%1\" already.").arg(name.trimmed()));
        return;
    }
    edit(tr("Rename take to \"%1\"").arg(name.trimmed()), [id, &name](model::Takes& takes) {
        std::ranges::find(takes, id, &model::Take::id)->name = name.trimmed().toStdString();
    });
}

void TakeShelf::setGhost(model::TakeId id)
{
    const model::Take* take = model::findTake(m_document.scene().takes, id);
    std::unique_ptr<TakePlayback> opened;
    if (take != nullptr) {
        auto playback = TakePlayback::open(*take, m_document.scene());
        if (playback) {
            opened = std::move(playback).value();
        } else {
            Q_EMIT failed(model::translated(playback.error().said));
        }
    }
    m_ghost = std::move(opened);
    m_ghostFrame.reset();
    Q_EMIT ghostChanged();
}

model::CrowdFramePtr TakeShelf::ghostFrame(double seconds) const
{
    if (!m_ghost) {
        return nullptr;
    }
    if (!m_ghostFrame || m_ghostFrame->seconds != seconds ||
        m_ghostRevision != m_document.revision()) {
        model::CrowdFrame frame = *m_document.frame(seconds);
        (void)m_ghost->pose(frame);
        m_ghostFrame = std::make_shared<const model::CrowdFrame>(std::move(frame));
        m_ghostRevision = m_document.revision();
    }
    return m_ghostFrame;
}

void TakeShelf::followScene(const model::SceneChange& change)
{
    if (isOneOf<model::SceneReplaced>(change)) {
        m_task.cancel(); // what was played was of another scene
    }
    if (!m_ghost ||
        !isOneOf<model::TakesChanged, model::TemplatesChanged, model::SceneReplaced>(change)) {
        return;
    }
    const model::Take* take = model::findTake(m_document.scene().takes, m_ghost->id());
    take = take != nullptr && take->isShown ? nullptr : take; // nobody is beside himself
    const bool knowsTemplates = !isOneOf<model::TemplatesChanged>(change);
    if (take == nullptr || !m_ghost->shows(*take) || !knowsTemplates) {
        setGhost(take != nullptr ? take->id : 0);
    }
}

} // namespace crowd::widgets
