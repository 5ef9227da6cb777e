// SPDX-License-Identifier: MIT
#include "widgets/docks/NumberList.h"

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

} // namespace crowd::widgets
