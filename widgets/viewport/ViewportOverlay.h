// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

#include "widgets/tools/ToolPicture.h"
#include "widgets/viewport/PathDrawing.h"
#include "widgets/viewport/PathLabels.h"
#include "widgets/viewport/PeopleMarks.h"

namespace crowd::widgets {

/// What lies over the picture as a whole rather than at the cursor.
struct OverlayText
{
    QString help; ///< in the middle: what to do in an empty scene
    QString mode; ///< above: "Flying – …"
    friend bool operator==(const OverlayText&, const OverlayText&) = default;
};

/// A transparent child over the viewport: moving the cursor repaints only this, never the scene.
/// Takes no events.
class ViewportOverlay : public QWidget
{
    Q_OBJECT

public:
    explicit ViewportOverlay(QWidget* parent);

    void setPicture(const ToolPicture& picture);
    /// The mouse cursor shows the brush: it is not painted here as well.
    void setBrushCarried(bool isCarried);
    void setText(const OverlayText& text);
    void setPlaces(const std::vector<PlaceLabel>& places);
    /// What the rings under people mean; empty: there are none.
    void setLegend(const std::vector<TagLabel>& tags);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintPlaces(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintCandidates(QPainter& painter) const;
    void paintAreas(QPainter& painter) const;
    [[nodiscard]] QRectF labelPlate() const;
    void paintLabel(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    ToolPicture m_picture;
    bool m_isBrushCarried = false;
    OverlayText m_text;
    std::vector<PlaceLabel> m_places;
    std::vector<TagLabel> m_legend;
    QPixmap m_symbol;
    std::optional<ToolId> m_symbolOf;
};

} // namespace crowd::widgets
