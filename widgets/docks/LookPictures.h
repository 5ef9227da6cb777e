// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "model/scene/LookPreset.h"
#include "widgets/docks/ViewPictures.h"

class QWidget;

namespace crowd::widgets {

/// Small pictures of the view in the looks of its scene, drawn while their panel is seen. A picture
/// stays until its look is changed. Main thread.
class LookPictures : public ViewPictures
{
    Q_OBJECT

public:
    static constexpr QSize kSize{64, 40}; ///< logical pixels

    /// The panel is the parent.
    LookPictures(EditorState& state, QWidget& panel);

    /// A plain symbol until it is drawn.
    [[nodiscard]] QIcon of(const model::LookPreset& look);

private:
    [[nodiscard]] bool isSeen() const override;
    [[nodiscard]] model::CrowdFramePtr frameOf(std::uint32_t id,
                                               render::RenderInput& input) const override;

    QWidget& m_panel;
    std::map<model::LookId, model::LookPreset> m_looks; ///< they are of
};

} // namespace crowd::widgets
