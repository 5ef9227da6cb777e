// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

class QBoxLayout;
class QCheckBox;
class QPushButton;

namespace crowd::widgets {

/// What the welcome page offers besides starting anew.
struct WelcomeOffer
{
    QStringList examples; ///< ready-made scenes; NAME.png beside NAME.crowd is its picture
    QStringList recent;   ///< opened or saved last, newest first
    bool isShownAtStart = true;
};

/// The first thing that somebody sees: ready-made scenes as pictures, new scenes, and what was
/// open before. It opens nothing itself; choosing something says so and closes it. Every choice can
/// be reached with the keyboard; Escape leaves what is behind the page.
class WelcomePage : public QDialog
{
    Q_OBJECT

public:
    WelcomePage(const WelcomeOffer& offer, QWidget* parent);

    /// What a second click of a double click would hit is what was behind the page.
    void accept() override;

Q_SIGNALS:
    void newTheatreChosen();
    void newGroundChosen();
    void openChosen();
    void libraryChosen();
    void sceneChosen(const QString& path);
    void showAtStartChanged(bool isShown);

private:
    [[nodiscard]] QBoxLayout* makeStarts(const QStringList& recent);
    [[nodiscard]] QBoxLayout* makeExamples(const QStringList& examples);
    [[nodiscard]] QPushButton* makeStart(const char* icon, const QString& text, const char* name);
    [[nodiscard]] QWidget* makeExample(const QString& path);
    void choose(const QString& path);
    /// Closes first, so that what is asked next does not stand behind this page.
    template<class Signal>
    void closeThen(Signal signal);
};

} // namespace crowd::widgets
