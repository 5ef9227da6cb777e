// SPDX-License-Identifier: MIT
#include "behavior/takes/TakeHead.h"

#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <utility>

#include <QtCore/QDataStream>
#include <QtCore/QIODevice>

#include "behavior/takes/PoseChecks.h"
#include "model/population/Properties.h"

namespace crowd::behavior {

namespace {

constexpr QDataStream::Version kStream = QDataStream::Qt_6_0;
constexpr std::uint32_t kMostShared = 10'000'000;

/// What several of a file share: each once, counted from 1 in the order in which they were met.
template<class T>
class Shared
{
public:
    [[nodiscard]] quint32 of(const std::shared_ptr<const T>& value)
    {
        if (!value) {
            return 0;
        }
        const auto [found, isNew] =
            m_numbers.emplace(value.get(), static_cast<quint32>(m_values.size() + 1));
        if (isNew) {
            m_values.push_back(value);
        }
        return found->second;
    }
    [[nodiscard]] const std::vector<std::shared_ptr<const T>>& values() const { return m_values; }

private:
    std::map<const T*, quint32> m_numbers;
    std::vector<std::shared_ptr<const T>> m_values;
};

template<class T>
void putValues(QDataStream& out, const std::vector<T>& values)
{
    const std::size_t bytes = values.size() * sizeof(T);
    out << QByteArray::fromRawData(reinterpret_cast<const char*>(values.data()),
                                   static_cast<qsizetype>(bytes));
}

void putColumn(QDataStream& out, model::ColumnId column)
{
    const std::string_view name = model::columnInfo(column).name;
    out << QByteArray(name.data(), static_cast<qsizetype>(name.size()));
}

/// One part of a head after the other, those first that others refer to.
class HeadWriter
{
public:
    [[nodiscard]] QByteArray bytes(const TakeHead& head);

private:
    void writeFrame(QDataStream& out, const TakeHead::Frame& frame);
    void writeOverrides(QDataStream& out);
    void writeFades(QDataStream& out);
    void writeCues(QDataStream& out);
    void writeNumbers(QDataStream& out);

    Shared<OverrideColumns> m_overrides;
    Shared<FadeColumns> m_fades;
    Shared<model::LightCues> m_cues;
    Shared<std::vector<OwnNumber>> m_numbers;
};

QByteArray HeadWriter::bytes(const TakeHead& head)
{
    QByteArray steps;
    QDataStream frames(&steps, QIODevice::WriteOnly);
    frames.setVersion(kStream);
    frames << static_cast<quint32>(head.pieces.size());
    for (const TakeHead::Piece& piece : head.pieces) {
        frames << static_cast<quint64>(piece.offset) << static_cast<quint64>(piece.size)
               << static_cast<quint64>(piece.checksum) << static_cast<quint32>(piece.frames.size());
        for (const TakeHead::Frame& frame : piece.frames) {
            writeFrame(frames, frame);
        }
    }
    QByteArray all;
    QDataStream out(&all, QIODevice::WriteOnly);
    out.setVersion(kStream);
    writeOverrides(out);
    writeFades(out);
    writeCues(out);
    writeNumbers(out);
    out.writeRawData(steps.constData(), static_cast<int>(steps.size()));
    return all;
}

void HeadWriter::writeFrame(QDataStream& out, const TakeHead::Frame& frame)
{
    const SessionPose& rest = *frame.rest;
    out << static_cast<quint64>(frame.begin) << static_cast<quint64>(frame.size)
        << frame.isDifference << static_cast<quint64>(rest.step) << rest.seconds << rest.hasSeats
        << static_cast<quint64>(rest.gone) << m_overrides.of(rest.overrides)
        << m_overrides.of(rest.recalled) << m_fades.of(rest.stateFades) << m_cues.of(rest.lightCues)
        << m_numbers.of(rest.numbers);
    putValues(out, rest.lit);
}

void HeadWriter::writeOverrides(QDataStream& out)
{
    // Steps share columns that nobody wrote, whatever else was written.
    std::map<const OverrideColumn*, quint32> numbers;
    std::vector<std::pair<model::ColumnId, const OverrideColumn*>> columns;
    std::vector<std::vector<quint32>> sets;
    for (const auto& all : m_overrides.values()) {
        auto& set = sets.emplace_back();
        for (std::size_t i = 0; i < model::kColumnCount; ++i) {
            const OverrideColumn* column = all->column(static_cast<model::ColumnId>(i));
            if (column == nullptr) {
                continue;
            }
            const auto [found, isNew] =
                numbers.emplace(column, static_cast<quint32>(columns.size()));
            if (isNew) {
                columns.emplace_back(static_cast<model::ColumnId>(i), column);
            }
            set.push_back(found->second);
        }
    }
    out << static_cast<quint32>(columns.size());
    for (const auto& [id, column] : columns) {
        putColumn(out, id);
        putValues(out, column->ids);
        putValues(out, column->bytes);
    }
    out << static_cast<quint32>(sets.size());
    for (const auto& set : sets) {
        putValues(out, set);
    }
}

void HeadWriter::writeFades(QDataStream& out)
{
    Shared<FadeTimes> times;
    Shared<FadeColumn> columns;
    std::vector<std::vector<quint32>> sets;
    for (const auto& all : m_fades.values()) {
        auto& set = sets.emplace_back();
        for (const auto& column : *all) {
            (void)times.of(column->times);
            set.push_back(columns.of(column) - 1);
        }
    }
    out << static_cast<quint32>(times.values().size());
    for (const auto& each : times.values()) {
        putValues(out, each->ids);
        putValues(out, each->begins);
        putValues(out, each->areWhole);
        out << each->seconds << each->end;
    }
    out << static_cast<quint32>(columns.values().size());
    for (const auto& each : columns.values()) {
        putColumn(out, each->column);
        out << times.of(each->times);
        putValues(out, each->bytes);
        putValues(out, each->phases);
        putValues(out, each->rates);
    }
    out << static_cast<quint32>(sets.size());
    for (const auto& set : sets) {
        putValues(out, set);
    }
}

void HeadWriter::writeCues(QDataStream& out)
{
    out << static_cast<quint32>(m_cues.values().size());
    for (const auto& cues : m_cues.values()) {
        out << static_cast<quint32>(cues->size());
        for (const model::LightCue& cue : *cues) {
            out << static_cast<quint32>(cue.light) << static_cast<double>(cue.from)
                << static_cast<double>(cue.to) << cue.fadeBegin
                << static_cast<double>(cue.fadeSeconds) << cue.flashBegin
                << static_cast<double>(cue.flashSeconds) << cue.sweepBegin
                << static_cast<double>(cue.sweepSeconds);
        }
    }
}

void HeadWriter::writeNumbers(QDataStream& out)
{
    out << static_cast<quint32>(m_numbers.values().size());
    for (const auto& numbers : m_numbers.values()) {
        out << static_cast<quint32>(numbers->size());
        for (const OwnNumber& own : *numbers) {
            out << static_cast<quint32>(own.number) << static_cast<quint32>(own.id)
                << static_cast<double>(own.value);
        }
    }
}

/// Reads what HeadWriter wrote. Once something is wrong, nothing that is read counts.
class HeadReader
{
public:
    explicit HeadReader(const QByteArray& bytes) : m_in(bytes) { m_in.setVersion(kStream); }
    [[nodiscard]] std::optional<TakeHead> read();

private:
    template<class T>
    T value()
    {
        T read{};
        m_in >> read;
        return read;
    }
    float real() { return static_cast<float>(value<double>()); }
    template<class T>
    std::vector<T> values();
    /// How many follow; none where it cannot be so many.
    quint32 count();
    model::ColumnId column();
    void demand(bool isSo) { m_isSound = m_isSound && isSo; }
    [[nodiscard]] bool goesOn() const { return m_isSound && m_in.status() == QDataStream::Ok; }
    template<class T>
    std::shared_ptr<const T> shared(const std::vector<std::shared_ptr<const T>>& all);

    void readOverrides();
    void readFades();
    void readCues();
    void readNumbers();
    TakeHead::Frame readFrame();

    QDataStream m_in;
    bool m_isSound = true;
    std::vector<std::shared_ptr<const OverrideColumns>> m_overrides;
    std::vector<std::shared_ptr<const FadeColumns>> m_fades;
    std::vector<std::shared_ptr<const model::LightCues>> m_cues;
    std::vector<std::shared_ptr<const std::vector<OwnNumber>>> m_numbers;
};

template<class T>
std::vector<T> HeadReader::values()
{
    const auto bytes = value<QByteArray>();
    std::vector<T> read(static_cast<std::size_t>(bytes.size()) / sizeof(T));
    demand(read.size() * sizeof(T) == static_cast<std::size_t>(bytes.size()));
    if (!read.empty()) {
        std::memcpy(read.data(), bytes.constData(), read.size() * sizeof(T));
    }
    return read;
}

quint32 HeadReader::count()
{
    const auto read = value<quint32>();
    demand(read <= kMostShared);
    return goesOn() ? read : 0;
}

model::ColumnId HeadReader::column()
{
    const auto name = value<QByteArray>();
    for (std::size_t i = 0; i < model::kColumnCount; ++i) {
        const auto id = static_cast<model::ColumnId>(i);
        if (model::columnInfo(id).name ==
            std::string_view(name.constData(), static_cast<std::size_t>(name.size()))) {
            return id;
        }
    }
    demand(false);
    return model::ColumnId::Clip;
}

template<class T>
std::shared_ptr<const T> HeadReader::shared(const std::vector<std::shared_ptr<const T>>& all)
{
    const auto number = value<quint32>();
    demand(number <= all.size());
    return number > 0 && goesOn() ? all[number - 1] : nullptr;
}

void HeadReader::readOverrides()
{
    std::vector<std::pair<model::ColumnId, std::shared_ptr<const OverrideColumn>>> columns;
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        const model::ColumnId id = column();
        auto of = std::make_shared<OverrideColumn>();
        of->ids = values<model::IndividualId>();
        of->bytes = values<std::byte>();
        demand(!of->ids.empty() && isSound(id, *of));
        columns.emplace_back(id, std::move(of));
    }
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto all = std::make_shared<OverrideColumns>();
        for (const quint32 number : values<quint32>()) {
            demand(number < columns.size());
            if (goesOn()) {
                all->put(columns[number].first, columns[number].second);
            }
        }
        m_overrides.push_back(std::move(all));
    }
}

void HeadReader::readFades()
{
    std::vector<std::shared_ptr<const FadeTimes>> times;
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto each = std::make_shared<FadeTimes>();
        each->ids = values<model::IndividualId>();
        each->begins = values<double>();
        each->areWhole = values<std::uint8_t>();
        each->seconds = value<double>();
        each->end = value<double>();
        demand(isSound(*each));
        times.push_back(std::move(each));
    }
    std::vector<std::shared_ptr<const FadeColumn>> columns;
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto each = std::make_shared<FadeColumn>();
        each->column = column();
        each->times = shared(times);
        each->bytes = values<std::byte>();
        each->phases = values<float>();
        each->rates = values<float>();
        demand(each->times && isSound(*each));
        columns.push_back(std::move(each));
    }
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto all = std::make_shared<FadeColumns>();
        for (const quint32 number : values<quint32>()) {
            demand(number < columns.size());
            if (goesOn()) {
                all->push_back(columns[number]);
            }
        }
        m_fades.push_back(std::move(all));
    }
}

void HeadReader::readCues()
{
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto cues = std::make_shared<model::LightCues>();
        for (quint32 each = count(); each > 0 && goesOn(); --each) {
            model::LightCue& cue = cues->emplace_back();
            cue.light = static_cast<model::LightId>(value<quint32>());
            cue.from = real();
            cue.to = real();
            cue.fadeBegin = value<double>();
            cue.fadeSeconds = real();
            cue.flashBegin = value<double>();
            cue.flashSeconds = real();
            cue.sweepBegin = value<double>();
            cue.sweepSeconds = real();
        }
        demand(isSound(*cues));
        m_cues.push_back(std::move(cues));
    }
}

void HeadReader::readNumbers()
{
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        auto numbers = std::make_shared<std::vector<OwnNumber>>();
        for (quint32 each = count(); each > 0 && goesOn(); --each) {
            OwnNumber& own = numbers->emplace_back();
            own.number = static_cast<model::NumberId>(value<quint32>());
            own.id = value<quint32>();
            own.value = real();
            demand(std::isfinite(own.value));
        }
        m_numbers.push_back(std::move(numbers));
    }
}

TakeHead::Frame HeadReader::readFrame()
{
    TakeHead::Frame frame;
    auto rest = std::make_shared<SessionPose>();
    frame.begin = value<quint64>();
    frame.size = value<quint64>();
    frame.isDifference = value<bool>();
    rest->step = value<quint64>();
    rest->seconds = value<double>();
    rest->hasSeats = value<bool>();
    rest->gone = static_cast<std::size_t>(value<quint64>());
    rest->overrides = shared(m_overrides);
    rest->recalled = shared(m_overrides);
    rest->stateFades = shared(m_fades);
    rest->lightCues = shared(m_cues);
    rest->numbers = shared(m_numbers);
    rest->lit = values<model::IndividualId>();
    demand(std::abs(rest->seconds) <= 2.0 * model::kLatestMark);
    frame.rest = std::move(rest);
    return frame;
}

std::optional<TakeHead> HeadReader::read()
{
    readOverrides();
    readFades();
    readCues();
    readNumbers();
    TakeHead head;
    double last = -1e300;
    for (quint32 left = count(); left > 0 && goesOn(); --left) {
        TakeHead::Piece piece;
        piece.offset = value<quint64>();
        piece.size = value<quint64>();
        piece.checksum = value<quint64>();
        for (quint32 frames = count(); frames > 0 && goesOn(); --frames) {
            TakeHead::Frame frame = readFrame();
            demand(frame.begin <= piece.size && frame.size <= piece.size - frame.begin &&
                   frame.rest->seconds > last && (!frame.isDifference || !piece.frames.empty()));
            last = frame.rest->seconds;
            piece.frames.push_back(std::move(frame));
        }
        demand(!piece.frames.empty());
        head.pieces.push_back(std::move(piece));
    }
    demand(!head.pieces.empty() && m_in.atEnd());
    if (!goesOn()) {
        return std::nullopt;
    }
    return head;
}

} // namespace

QByteArray takeHeadBytes(const TakeHead& head)
{
    return HeadWriter().bytes(head);
}

std::optional<TakeHead> takeHeadOf(const QByteArray& bytes)
{
    return HeadReader(bytes).read();
}

} // namespace crowd::behavior
