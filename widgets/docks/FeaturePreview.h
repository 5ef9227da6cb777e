// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "model/scene/Feature.h"
#include "model/scene/Scene.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// Six people of the scene's templates who bear a value, three who stand and three who sit, moving
/// as it lets them. Drawn only while it is seen, in the renderer that thumbnails share. Main
/// thread.
class FeaturePreview : public QWidget
{
    Q_OBJECT

public:
    FeaturePreview(EditorState& state, QWidget* parent);

    /// Null: nobody.
    void setFeature(const model::FeatureValue* value);
    [[nodiscard]] QSize sizeHint() const override { return {240, 110}; }
    [[nodiscard]] const model::Scene& people() const { return m_people; } ///< who are drawn

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void beat();
    [[nodiscard]] QImage picture() const;

    EditorState& m_state;
    model::Scene m_people;
    std::vector<model::WorldSeat> m_seats;
    std::uint64_t m_seatsVersion = 0;
    double m_seconds = 0.0;
    QTimer m_clock;
};

} // namespace crowd::widgets
