// SPDX-License-Identifier: MIT
#include "app/commands/BenchReport.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <QtCore/QJsonDocument>
#include <QtCore/QVariant>

namespace crowd::app {

double rounded(double value)
{
    return std::round(value * 1000.0) / 1000.0;
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

double nowMs()
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

void printReport(const QJsonObject& report, bool isJson)
{
    if (isJson) {
        std::cout << QJsonDocument(report).toJson(QJsonDocument::Compact).toStdString() << '\n';
        return;
    }
    for (auto item = report.begin(); item != report.end(); ++item) {
        std::cout << item.key().toStdString() << ": "
                  << item.value().toVariant().toString().toStdString() << '\n';
    }
}

} // namespace crowd::app
