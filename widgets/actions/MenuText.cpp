// SPDX-License-Identifier: MIT
#include "widgets/actions/MenuText.h"

namespace crowd::widgets {

QString menuText(const QString& text)
{
    QString read;
    read.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == QLatin1Char('&') && i + 1 < text.size()) {
            ++i;
        }
        read += text[i];
    }
    return read;
}

} // namespace crowd::widgets
