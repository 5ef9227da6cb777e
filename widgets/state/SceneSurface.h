// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "behavior/surface/SurfacePlan.h"
#include "model/base/Message.h"
#include "model/base/Result.h"
#include "model/document/SceneDocument.h"
#include "widgets/state/SurfaceBuilder.h"

namespace crowd::widgets {

/// What can be walked on in the document's scene: found in the background where somebody may walk,
/// or a path is to be shown, and it is more than open ground, and anew when stages or areas change.
/// Main thread; the document outlives it.
class SceneSurface : public QObject
{
    Q_OBJECT

public:
    explicit SceneSurface(model::SceneDocument& document, QObject* parent = nullptr);

    /// Whether a run can begin; begins to find what it would need.
    [[nodiscard]] bool isReady();
    /// What is in use, also while another is being found; null: open ground, or nothing yet.
    [[nodiscard]] const SurfacePtr& current() const { return m_current; }
    /// The same, if it is of the stages and areas of now.
    [[nodiscard]] SurfacePtr known() const;
    /// Share that is built; below 0: nothing is being built.
    [[nodiscard]] double progress() const;
    /// Of what is in use; 0: open ground.
    [[nodiscard]] std::size_t polygons() const;
    /// Why it could not be found; empty otherwise.
    [[nodiscard]] const model::Message& problem() const { return m_problem; }

Q_SIGNALS:
    /// Another is in use, for those who walk.
    void used();
    /// It is being built, or is done, or is of no use any more.
    void changed();
    /// What was being built is there, or could not be found.
    void found();

private:
    void followScene(const model::SceneChange& change);
    void followWays();
    void forget();
    void build();
    void take(const model::Result<SurfacePtr>& built);

    model::SceneDocument& m_document;
    SurfacePtr m_current;
    behavior::SurfacePlan m_plan; ///< of the one that is there or being built
    SurfaceBuilder m_builder;
    model::Message m_problem;
    QTimer m_progress; ///< while it is built
    QTimer m_ways;     ///< until areas that are being changed come to rest
    bool m_isStale = true;
};

} // namespace crowd::widgets
