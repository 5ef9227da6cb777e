// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QString>

/// The languages of the interface: those that there is a translation of in the program. Main thread
/// only.
namespace crowd::app {

struct Language
{
    QString code; ///< "de"
    QString name; ///< as those say who speak it: "Deutsch"
};

/// By their codes.
[[nodiscard]] std::vector<Language> languages();

/// Words, those of Qt's own dialogs too, and numbers in fields are of this language from now on;
/// empty: the system's. Windows that are open get QEvent::LanguageChange. Files know no language.
void useLanguage(const QString& code);
/// What was asked for last.
[[nodiscard]] QString languageInUse();

} // namespace crowd::app
