// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>

#include "model/scene/State.h"
#include "widgets/docks/ViewPictures.h"

namespace crowd::widgets {

/// Small pictures of the scene in its states, as the view shows it when they are drawn. A picture
/// stays until its state is kept anew. Main thread.
class StatePictures : public ViewPictures
{
    Q_OBJECT

public:
    static constexpr QSize kSize{56, 36}; ///< logical pixels

    StatePictures(EditorState& state, QObject* parent);

    /// A plain symbol until it is drawn.
    [[nodiscard]] QIcon of(const model::State& kept);

private:
    [[nodiscard]] model::CrowdFramePtr frameOf(std::uint32_t id,
                                               render::RenderInput& input) const override;

    std::map<model::StateId, std::shared_ptr<const model::StoredRows>> m_people; ///< they are of
};

} // namespace crowd::widgets
