// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

#include "widgets/tools/ToolPicture.h"
#include "widgets/viewport/PathDrawing.h"

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
    void setText(const OverlayText& text);
    void setPlaces(const std::vector<PlaceLabel>& places);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintPlaces(QPainter& painter) const;
    void paintAreas(QPainter& painter) const;
    void paintSymbol(QPainter& painter) const;
    void paintLabel(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    ToolPicture m_picture;
    OverlayText m_text;
    std::vector<PlaceLabel> m_places;
    QPixmap m_symbol;
    std::optional<ToolId> m_symbolOf;
};

} // namespace crowd::widgets
