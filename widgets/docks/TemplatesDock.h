// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QListWidget;
class QListWidgetItem;
class QSlider;
class QLabel;

namespace crowd::widgets {

/// The scene's templates as swatches with rendered pictures. A tick puts one into the create
/// brush's mix; the slider sets its weight in the mix.
class TemplatesDock : public DockBase
{
    Q_OBJECT

public:
    TemplatesDock(EditorState& state, QWidget* parent);

Q_SIGNALS:
    void importRequested();
    void locateRequested(crowd::model::TemplateId id);
    void removeRequested(crowd::model::TemplateId id);

private:
    void rebuild();
    void refreshMix();
    void setInMix(model::TemplateId id, bool isIn);
    void setWeight(int percent);
    void showMenu(const QPoint& position);
    void rename(QListWidgetItem* item);
    [[nodiscard]] model::TemplateId currentId() const;
    [[nodiscard]] QIcon pictureOf(const model::TemplateEntry& entry);

    EditorState& m_state;
    QListWidget* m_list;
    QSlider* m_weight;
    QLabel* m_weightLabel;
    QTimer m_rebuild; ///< several changes in a row make one rebuild
    std::map<model::TemplatePtr, QIcon> m_pictures;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
