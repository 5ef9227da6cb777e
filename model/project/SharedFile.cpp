// SPDX-License-Identifier: MIT
#include "model/project/SharedFile.h"

#include <string>
#include <utility>

#include <QtCore/QByteArray>
#include <QtCore/QFile>

#include "model/project/WholeFile.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr int kDeepestPart = 64;            ///< as project files
constexpr qint64 kMostPartBytes = 16 << 20; ///< no part is larger

bool isOf(const json& content, const SharedFormat& format)
{
    return content.is_object() && content.contains("format") && content["format"].is_string() &&
           content["format"] == format.name;
}

} // namespace

Result<void> writeSharedFile(const QString& path, const SharedFormat& format, const char* key,
                             json part)
{
    const json content = {
        {"format", format.name}, {"version", format.version}, {key, std::move(part)}};
    return writeWholeFile(path, content.dump(2, ' ', false, json::error_handler_t::replace));
}

Result<json> readSharedFile(const QString& path, const SharedFormat& format)
{
    const std::string name = path.toStdString();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be read: %2"), name,
                     file.errorString().toStdString()};
    }
    if (file.size() > kMostPartBytes) {
        return Error{format.notOne, name};
    }
    const QByteArray bytes = file.read(kMostPartBytes);
    bool isTooDeep = false; // writing what is not known goes down as deep
    const auto notTooDeep = [&isTooDeep](int depth, json::parse_event_t, const json&) {
        isTooDeep = isTooDeep || depth > kDeepestPart;
        return !isTooDeep;
    };
    json content = json::parse(bytes.begin(), bytes.end(), notTooDeep, false);
    if (isTooDeep || !isOf(content, format)) {
        return Error{format.notOne, name};
    }
    if (content.contains("version") && content["version"].is_number_integer() &&
        content["version"] > format.version) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "%1 was written by a newer version; update to use it."),
            name};
    }
    return content;
}

} // namespace crowd::model
