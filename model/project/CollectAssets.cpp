// SPDX-License-Identifier: MIT
#include "model/project/CollectAssets.h"

#include <string_view>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QHash>
#include <QtCore/QtEndian>

#include <nlohmann/json.hpp>

#include "model/project/AssetPaths.h"
#include "model/project/WholeFile.h"

namespace crowd::model {

namespace {

using nlohmann::json;

Error copyError(const QString& file, const Message& why)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1: could not be copied (%2). Make room there or "
                                               "choose another place, then try again."),
                 file.toStdString(), why};
}

/// The JSON of a .gltf, or of a .glb's first chunk (12 bytes of header, then its length and kind).
QByteArray jsonOf(const QByteArray& bytes)
{
    constexpr qsizetype kLengthAt = 12;
    constexpr qsizetype kJsonAt = 20;
    if (!bytes.startsWith("glTF") || bytes.size() < kJsonAt) {
        return bytes;
    }
    return bytes.mid(kJsonAt, qFromLittleEndian<quint32>(bytes.constData() + kLengthAt));
}

/// Files that a model names in its buffers and images, relative to it.
QStringList referencedFiles(const QString& asset)
{
    QFile file(asset);
    QStringList names;
    if (!file.open(QIODevice::ReadOnly)) {
        return names;
    }
    const QByteArray text = jsonOf(file.readAll());
    const json top = json::parse(text.constData(), text.constData() + text.size(), nullptr, false);
    for (const char* list : {"buffers", "images"}) {
        if (!top.is_object() || !top.contains(list) || !top[list].is_array()) {
            continue;
        }
        for (const json& item : top[list]) {
            if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) {
                continue;
            }
            const auto uri = QByteArray::fromStdString(item["uri"].get<std::string>());
            if (!uri.isEmpty() && !uri.startsWith("data:")) {
                names << QString::fromUtf8(QByteArray::fromPercentEncoding(uri));
            }
        }
    }
    return names;
}

/// Whole or not at all: an older copy is replaced only when the new one is complete.
Result<void> copyFile(const QString& from, const QString& to)
{
    if (QFileInfo(from) == QFileInfo(to)) {
        return {};
    }
    QFile source(from);
    if (!QDir().mkpath(QFileInfo(to).absolutePath())) {
        return copyError(from, QFileInfo(to).absolutePath().toStdString());
    }
    if (!source.open(QIODevice::ReadOnly)) {
        return copyError(from, source.errorString().toStdString());
    }
    const auto problem = [&](const Error& why) {
        return copyError(from,
                         {QT_TRANSLATE_NOOP("Messages", "%1: %2"), to.toStdString(), why.said});
    };
    auto target = WholeFile::begin(to);
    if (!target) {
        return problem(target.error());
    }
    constexpr qint64 kPiece = 1 << 20;
    while (!source.atEnd()) {
        const QByteArray piece = source.read(kPiece);
        if (piece.isEmpty()) {
            return copyError(from, source.errorString().toStdString());
        }
        const std::string_view bytes(piece.constData(), static_cast<std::size_t>(piece.size()));
        if (const auto written = target.value().write(bytes); !written) {
            return problem(written.error());
        }
    }
    if (const auto done = target.value().commit(); !done) {
        return problem(done.error());
    }
    return {};
}

bool haveSameBytes(const QString& a, const QString& b)
{
    QFile first(a);
    QFile second(b);
    return QFileInfo(b).isFile() && first.open(QIODevice::ReadOnly) &&
           second.open(QIODevice::ReadOnly) && first.size() == second.size() &&
           first.readAll() == second.readAll();
}

class Collector
{
public:
    explicit Collector(const QString& folder) : m_assets(folder + QStringLiteral("/assets")) {}

    template<class Entry>
    Result<void> collect(const std::vector<Entry>& entries, std::vector<Entry>& changed)
    {
        for (Entry entry : entries) {
            const QString file = QString::fromStdString(entry.path);
            if (isBuiltin(entry.path) || isCollected(file)) {
                continue;
            }
            if (!QFileInfo(file).isFile()) {
                m_leftBehind << file;
                continue;
            }
            const Result<QString> copied = copyOf(file);
            if (!copied) {
                return copied.error();
            }
            entry.path = copied.value().toStdString();
            changed.push_back(std::move(entry));
        }
        return {};
    }
    [[nodiscard]] const QStringList& leftBehind() const { return m_leftBehind; }

private:
    [[nodiscard]] bool isCollected(const QString& file) const
    {
        return QDir::cleanPath(file).startsWith(QDir::cleanPath(m_assets) + QLatin1Char('/'));
    }

    /// A folder that no other asset has, unless it holds the very same file from an earlier time.
    [[nodiscard]] QString folderFor(const QFileInfo& source)
    {
        for (int number = 1;; ++number) {
            QString name = source.completeBaseName();
            if (number > 1) {
                name += QLatin1Char('-') + QString::number(number);
            }
            QString folder = m_assets + QLatin1Char('/') + name;
            const QString earlier = folder + QLatin1Char('/') + source.fileName();
            const bool isFree =
                !QFileInfo::exists(folder) || haveSameBytes(source.absoluteFilePath(), earlier);
            if (isFree && !m_taken.contains(folder)) {
                m_taken << folder;
                return folder;
            }
        }
    }

    Result<QString> copyOf(const QString& file)
    {
        if (const auto known = m_copies.constFind(file); known != m_copies.constEnd()) {
            return *known;
        }
        const QFileInfo source(file);
        const QDir target(folderFor(source));
        for (const QString& name : referencedFiles(file)) {
            const QString inside = QDir::cleanPath(target.absoluteFilePath(name));
            const QString from = source.dir().absoluteFilePath(name);
            // What lies outside the model's folder may be anything, and stays there.
            if (!inside.startsWith(target.absolutePath() + QLatin1Char('/')) ||
                !QFileInfo(from).isFile()) {
                m_leftBehind << from;
                continue;
            }
            if (const Result<void> copied = copyFile(from, inside); !copied) {
                return copied.error();
            }
        }
        const QString copy = target.absoluteFilePath(source.fileName());
        if (const Result<void> copied = copyFile(file, copy); !copied) {
            return copied.error();
        }
        m_copies.insert(file, copy);
        return copy;
    }

    QString m_assets;
    QStringList m_taken;
    QHash<QString, QString> m_copies; ///< source → copy
    QStringList m_leftBehind;
};

} // namespace

Result<CollectedEntries> collectAssets(const Scene& scene, const QString& folder)
{
    CollectedEntries collected;
    Collector collector(folder);
    if (const auto done = collector.collect(scene.templates, collected.templates); !done) {
        return done.error();
    }
    if (const auto done = collector.collect(scene.stages, collected.stages); !done) {
        return done.error();
    }
    collected.leftBehind = collector.leftBehind();
    return collected;
}

} // namespace crowd::model
