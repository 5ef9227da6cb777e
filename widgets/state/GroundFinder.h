// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtCore/QObject>

#include "behavior/surface/GroundKeeper.h"
#include "model/document/SceneDocument.h"

namespace crowd::widgets {

/// Where people can walk in the document: found in the background from when somebody may soon ask
/// for it. Main thread; the document outlives it.
class GroundFinder : public QObject
{
    Q_OBJECT

public:
    explicit GroundFinder(model::SceneDocument& document, QObject* parent = nullptr);
    ~GroundFinder() override;

    /// Null: it is not there yet, and is being found from now on; or there is only open ground.
    [[nodiscard]] model::WalkableGroundPtr soon();
    /// Waits until it is there, which may take seconds: `waiting` tells. Null: there is only open ground.
    [[nodiscard]] model::WalkableGroundPtr wait();

Q_SIGNALS:
    /// It is being found, and somebody waits; or that is over.
    void waiting(bool isWaiting);

private:
    struct Search;

    void begin();

    model::SceneDocument& m_document;
    behavior::GroundKeeper m_keeper;
    std::unique_ptr<Search> m_search; ///< null: nothing was asked for since the stages changed
};

} // namespace crowd::widgets
