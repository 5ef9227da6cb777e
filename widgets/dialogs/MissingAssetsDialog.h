// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QDialog>

#include "model/project/LocateAssets.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace crowd::widgets {

/// Names the assets that the open scene lacks and lets the artist say where each is now. Follows
/// the document: what was found leaves the list, and when nothing is missing the dialog closes.
class MissingAssetsDialog : public QDialog
{
    Q_OBJECT

public:
    MissingAssetsDialog(EditorState& state, QWidget* parent);

Q_SIGNALS:
    /// Ask for the file and load it.
    void locateRequested(const crowd::model::MissingAsset& asset);

private:
    void refresh();
    void locateCurrent();

    EditorState& m_state;
    QLabel* m_text;
    QTreeWidget* m_list;
    QPushButton* m_locate;
    std::vector<model::MissingAsset> m_missing; ///< as listed
};

} // namespace crowd::widgets
