// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "model/document/SceneDocument.h"
#include "model/pick/WalkableGround.h"
#include "widgets/state/SurfaceBuilder.h"

namespace crowd::widgets {

/// Where people can walk in the document: found in the background from when somebody may soon ask
/// for it, and kept as long as the stages stay as they are. Main thread; the document outlives it.
class GroundFinder : public QObject
{
    Q_OBJECT

public:
    explicit GroundFinder(model::SceneDocument& document, QObject* parent = nullptr);
    ~GroundFinder() override;

    /// Null: it is not there yet, and is being found from now on; or there is only open ground.
    [[nodiscard]] model::WalkableGroundPtr soon();
    /// Waits until it is there, which may take seconds: `waiting` tells. Null: there is only open
    /// ground.
    [[nodiscard]] model::WalkableGroundPtr wait();
    [[nodiscard]] bool isFinding() const { return m_builder.isBuilding(); } ///< in the background

Q_SIGNALS:
    /// It is there now.
    void changed();
    /// It is being found from now on, or no longer.
    void findingChanged(bool isFinding);
    /// It is being found, and somebody waits; or that is over.
    void waiting(bool isWaiting);

private:
    void begin();
    void forget(); ///< what belongs to other stages

    model::SceneDocument& m_document;
    behavior::SurfacePlan m_plan; ///< of what is found or being found
    bool m_isBegun = false;
    model::WalkableGroundPtr m_found;
    SurfaceBuilder m_builder;
};

} // namespace crowd::widgets
