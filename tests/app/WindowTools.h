// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include <QtCore/QPointer>
#include <QtCore/QTimer>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>

/// Help for tests of the real window: answering the dialogs it opens.
namespace crowd::testing {

/// The dialog that is open now, modal or window-modal; of several the one that takes input; null
/// if none.
inline QDialog* openDialog()
{
    auto* active = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (active != nullptr && active->isVisible() && !active->inherits("QProgressDialog")) {
        return active;
    }
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* dialog = qobject_cast<QDialog*>(widget);
        if (dialog != nullptr && dialog->isVisible() && !dialog->inherits("QProgressDialog")) {
            return dialog;
        }
    }
    return nullptr;
}

/// Waits for a dialog while the event loop of another dialog may run, then hands it to `act`; once.
/// Tells afterwards whether one came.
class DialogAnswer : public QObject
{
public:
    explicit DialogAnswer(std::function<void(QDialog&)> act) : m_act(std::move(act))
    {
        QObject::connect(&m_timer, &QTimer::timeout, this, [this] {
            if (QDialog* dialog = openDialog()) {
                m_timer.stop();
                m_hasAnswered = true;
                m_title = dialog->windowTitle();
                m_act(*dialog);
            }
        });
        m_timer.start(20);
    }
    [[nodiscard]] bool hasAnswered() const { return m_hasAnswered; }
    [[nodiscard]] const QString& title() const { return m_title; }

private:
    std::function<void(QDialog&)> m_act;
    QTimer m_timer;
    bool m_hasAnswered = false;
    QString m_title;
};

/// Presses one of the standard buttons of a message box.
inline std::function<void(QDialog&)> pressing(QMessageBox::StandardButton button)
{
    return [button](QDialog& dialog) {
        auto* box = qobject_cast<QMessageBox*>(&dialog);
        QAbstractButton* target = box == nullptr ? nullptr : box->button(button);
        target != nullptr ? target->click() : dialog.reject();
    };
}

/// Presses the button with this text (mnemonics aside).
inline std::function<void(QDialog&)> pressing(const QString& text)
{
    return [text](QDialog& dialog) {
        for (QAbstractButton* button : dialog.findChildren<QAbstractButton*>()) {
            if (button->text().remove(QLatin1Char('&')) == text) {
                button->click();
                return;
            }
        }
        dialog.reject();
    };
}

/// Types a path into the dialog that asks for a file; another dialog is dismissed.
inline std::function<void(QDialog&)> choosing(const QString& path)
{
    return [path](QDialog& dialog) {
        auto* files = qobject_cast<QFileDialog*>(&dialog);
        auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        if (files == nullptr || name == nullptr) {
            dialog.reject();
            return;
        }
        for (auto* view : dialog.findChildren<QAbstractItemView*>()) {
            view->clearSelection(); // else the file it offers is taken
        }
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
    };
}

/// A dialog of ours, which is accepted, and the file dialog that follows it. False: that did not
/// come. `trigger` opens the first.
inline bool answerBoth(const std::function<void()>& trigger,
                       const std::function<void(QDialog&)>& choose, const QString& path)
{
    bool isFileDialog = false;
    std::unique_ptr<DialogAnswer> file;
    const DialogAnswer dialog([&](QDialog& shown) {
        choose(shown);
        file = std::make_unique<DialogAnswer>([&](QDialog& chooser) {
            isFileDialog = chooser.inherits("QFileDialog");
            choosing(path)(chooser);
        });
        shown.accept();
    });
    trigger();
    return isFileDialog;
}

} // namespace crowd::testing
