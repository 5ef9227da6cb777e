// SPDX-License-Identifier: MIT
#include "widgets/actions/Findable.h"

#include <algorithm>
#include <utility>

#include <QtCore/QStringList>

namespace crowd::widgets {

namespace {

constexpr int kNoFit = 1000;
constexpr qsizetype kShortestGuess = 3; ///< letters: fewer come in this order in nearly every word

/// Without case and accents.
QString plain(const QString& text)
{
    QString letters;
    letters.reserve(text.size());
    for (const QChar letter : text.normalized(QString::NormalizationForm_KD)) {
        if (letter.category() != QChar::Mark_NonSpacing) {
            letters += letter.isLetterOrNumber() ? letter.toLower() : QLatin1Char(' ');
        }
    }
    return letters.simplified();
}

bool hasWordBeginning(const QString& text, const QString& word)
{
    return text.startsWith(word) || text.contains(QLatin1Char(' ') + word);
}

/// Whether all letters come in a word that begins as they do, in their order.
bool isGuess(const QString& name, const QString& letters)
{
    if (letters.size() < kShortestGuess) {
        return false;
    }
    const QStringList words = name.split(QLatin1Char(' '));
    return std::ranges::any_of(words, [&](const QString& word) {
        if (!word.startsWith(letters.front())) {
            return false;
        }
        qsizetype at = 0;
        for (const QChar letter : letters) {
            at = word.indexOf(letter, at) + 1;
            if (at == 0) {
                return false;
            }
        }
        return true;
    });
}

/// What is asked for all words of one.
struct PlainTexts
{
    QString name;
    QString place;
    QString words;
    QString tip;
};

int fitOf(const QString& word, const PlainTexts& texts)
{
    if (texts.name == word) {
        return 0;
    }
    if (texts.name.startsWith(word)) {
        return 1;
    }
    if (hasWordBeginning(texts.name, word)) {
        return 2;
    }
    if (texts.name.contains(word)) {
        return 3;
    }
    if (hasWordBeginning(texts.place, word)) {
        return 4;
    }
    if (hasWordBeginning(texts.words, word)) {
        return 5;
    }
    if (hasWordBeginning(texts.tip, word)) {
        return 6;
    }
    return isGuess(texts.name, word) ? 10 : kNoFit;
}

} // namespace

std::vector<std::size_t> foundBy(const QString& typed, const std::vector<Findable>& all)
{
    const QStringList words = plain(typed).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<std::pair<int, std::size_t>> fits;
    fits.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const PlainTexts texts{plain(all[i].name), plain(all[i].place), plain(all[i].words),
                               plain(all[i].tip)};
        int sum = 0;
        for (const QString& word : words) {
            sum += fitOf(word, texts);
        }
        if (sum < kNoFit) {
            fits.emplace_back(sum, i);
        }
    }
    std::ranges::sort(fits);
    std::vector<std::size_t> found;
    found.reserve(fits.size());
    for (const auto& [fit, index] : fits) {
        found.push_back(index);
    }
    return found;
}

} // namespace crowd::widgets
