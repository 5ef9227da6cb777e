// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace crowd::widgets {

class ValueSlider;

/// The scene's templates as swatches with rendered pictures. A tick puts one into the create
/// brush's mix; the slider sets its weight in the mix.
class TemplatesDock : public DockBase
{
    Q_OBJECT

public:
    TemplatesDock(EditorState& state, QWidget* parent);

Q_SIGNALS:
    void importRequested();
    void libraryRequested();
    void locateRequested(crowd::model::TemplateId id);
    void clipsRequested(crowd::model::TemplateId id);
    void removeRequested(crowd::model::TemplateId id);

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectParts();
    void rebuild();
    void refreshMix();
    void setInMix(model::TemplateId id, bool isIn);
    void setWeight(double percent);
    void showMenu(const QPoint& position);
    void rename(QListWidgetItem* item);
    [[nodiscard]] model::TemplateId currentId() const;
    [[nodiscard]] QIcon pictureOf(const model::TemplateEntry& entry);

    EditorState& m_state;
    QListWidget* m_list;
    ValueSlider* m_weight;
    QToolButton* m_library;
    QToolButton* m_import;
    QTimer m_rebuild; ///< several changes in a row make one rebuild
    std::map<model::TemplatePtr, QIcon> m_pictures;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
