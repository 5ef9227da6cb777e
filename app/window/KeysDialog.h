// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "app/window/QuickCard.h"
#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// What mouse buttons and keys do, as they are set now: the quick reference card, which can be kept
/// as a page to print, and all shortcuts.
class KeysDialog : public QDialog
{
    Q_OBJECT

public:
    KeysDialog(const widgets::ActionRegistry& actions, widgets::ButtonMapping buttons,
               QWidget* parent);

    /// What the mouse does in the picture, and the keys beside it.
    static void addMouse(CardList& list, widgets::ButtonMapping buttons);

private:
    static void addPainting(CardList& list, widgets::ButtonMapping buttons);
    static void addLooking(CardList& list);
    [[nodiscard]] QWidget* cardPage();
    [[nodiscard]] QWidget* shortcutPage(const widgets::ActionRegistry& actions);
    void saveCard();

    std::vector<CardSection> m_sections; ///< of the card
};

} // namespace crowd::app
