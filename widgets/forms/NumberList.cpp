// SPDX-License-Identifier: MIT
#include "widgets/forms/NumberList.h"

#include <algorithm>
#include <set>

#include <QtCore/QRegularExpression>
#include <QtCore/QStringList>

namespace crowd::widgets {

QString numberListText(const std::vector<int>& numbers)
{
    QStringList texts;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        texts << (last > i + 1 ? QStringLiteral("%1-%2").arg(numbers[i] + 1).arg(numbers[last] + 1)
                               : QString::number(numbers[i] + 1));
        i = last > i + 1 ? last : i;
    }
    return texts.join(QStringLiteral(", "));
}

std::vector<int> numberListOf(const QString& text)
{
    static const QRegularExpression kPiece(QStringLiteral("(\\d{1,4})(?:\\s*[-–]\\s*(\\d{1,4}))?"));
    std::set<int> numbers;
    auto pieces = kPiece.globalMatch(text);
    while (pieces.hasNext()) {
        const auto piece = pieces.next();
        const int first = piece.captured(1).toInt();
        const int last = piece.captured(2).isEmpty() ? first : piece.captured(2).toInt();
        const auto [low, high] = std::minmax(first, last);
        for (int number = std::max(low, 1); number <= high; ++number) {
            numbers.insert(number - 1);
        }
    }
    return {numbers.begin(), numbers.end()};
}

QString tagListText(const std::vector<model::TagName>& names, std::uint64_t tags)
{
    QStringList named;
    std::vector<int> others;
    for (int bit = 0; bit < model::kTagCount; ++bit) {
        if ((tags >> static_cast<unsigned>(bit) & 1U) == 0) {
            continue;
        }
        const auto known = std::ranges::find(names, bit, &model::TagName::bit);
        if (known != names.end() && !known->name.empty()) {
            named << QString::fromStdString(known->name);
        } else {
            others.push_back(bit);
        }
    }
    if (!others.empty()) {
        named << numberListText(others);
    }
    return named.join(QStringLiteral(", "));
}

std::uint64_t tagListOf(const std::vector<model::TagName>& names, const QString& text)
{
    std::uint64_t tags = 0;
    for (const QString& piece : text.split(QLatin1Char(','))) {
        const auto known = std::ranges::find_if(names, [&](const model::TagName& tag) {
            return QString::fromStdString(tag.name).compare(piece.trimmed(), Qt::CaseInsensitive) ==
                   0;
        });
        if (known != names.end() && !known->name.empty()) {
            tags |= std::uint64_t{1} << known->bit;
            continue;
        }
        for (const int bit : numberListOf(piece)) {
            tags |= bit < model::kTagCount ? std::uint64_t{1} << static_cast<unsigned>(bit) : 0;
        }
    }
    return tags;
}

} // namespace crowd::widgets
