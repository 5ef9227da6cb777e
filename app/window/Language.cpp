// SPDX-License-Identifier: MIT
#include "app/window/Language.h"

#include <memory>

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QLibraryInfo>
#include <QtCore/QLocale>
#include <QtCore/QTranslator>
#include <QtCore/QVariant>

namespace crowd::app {

namespace {

const QString kFolder = QStringLiteral(":/translations");
const QString kPrefix = QStringLiteral("crowdbrush_");
const QString kTranslator = QStringLiteral("language"); ///< the name of those installed here
const char* const kInUse = "language";                  ///< property of the application

/// Qt's translations leave the name of this key as it is.
[[maybe_unused]] constexpr const char* kKeys[] = {QT_TRANSLATE_NOOP("QShortcut", "Return")};

void install(std::unique_ptr<QTranslator> translator)
{
    translator->setParent(QCoreApplication::instance());
    translator->setObjectName(kTranslator);
    QCoreApplication::installTranslator(translator.release());
}

/// Qt's own words: buttons of its dialogs, names of keys. They come with the system.
void installQtWords(const QLocale& locale)
{
    auto translator = std::make_unique<QTranslator>();
    if (translator->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                         QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        install(std::move(translator));
    }
}

void installOwnWords(const QLocale& locale)
{
    auto translator = std::make_unique<QTranslator>();
    if (translator->load(locale, QStringLiteral("crowdbrush"), QStringLiteral("_"), kFolder) ||
        translator->load(kFolder + QStringLiteral("/crowdbrush_en.qm"))) {
        install(std::move(translator));
    }
}

} // namespace

std::vector<Language> languages()
{
    std::vector<Language> found;
    for (const QString& file :
         QDir(kFolder).entryList({kPrefix + QStringLiteral("*.qm")}, QDir::Files, QDir::Name)) {
        QTranslator words;
        if (words.load(file, kFolder)) {
            //: the name of this language in this language
            const char* const own = QT_TRANSLATE_NOOP("Languages", "English");
            const QString name = words.translate("Languages", own);
            found.push_back({file.chopped(3).mid(kPrefix.size()),
                             name.isEmpty() ? QString::fromLatin1(own) : name});
        }
    }
    return found;
}

void useLanguage(const QString& code)
{
    QCoreApplication& application = *QCoreApplication::instance();
    qDeleteAll(application.findChildren<QTranslator*>(kTranslator, Qt::FindDirectChildrenOnly));
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale);
    installQtWords(locale);
    installOwnWords(locale);
    application.setProperty(kInUse, code);
}

QString languageInUse()
{
    return QCoreApplication::instance()->property(kInUse).toString();
}

} // namespace crowd::app
