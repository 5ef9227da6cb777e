// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QtGui/QImage>

/// Whether two pictures show the same, whatever drew them.
namespace crowd::testing {

/// How two pictures of one size differ, in steps of 255. Drivers differ in single pixels along
/// edges and by a step or two everywhere; a person too few, another tint or another light changes
/// whole neighbourhoods.
struct PictureDifference
{
    double shift = 0.0; ///< the largest mean of one channel, with its sign
    double worst = 0.0; ///< the largest mean of one channel in a square of kSquare pixels
    int x = 0;          ///< where that square is: its left top pixel
    int y = 0;

    static constexpr int kSquare = 5;

    [[nodiscard]] bool isVisible() const
    {
        // Another smoothing of edges and other levels of detail make 25 in a picture full of
        // people; a person, even half hidden and a dozen pixels high, 33 and more; a tenth of the
        // light 1.7.
        return std::abs(shift) > 1.5 || worst > 30.0;
    }
};

class PictureComparison
{
public:
    PictureComparison(const QImage& a, const QImage& b)
        : m_width(a.width()), m_height(a.height()),
          m_sums(static_cast<std::size_t>(m_width + 1) * static_cast<std::size_t>(m_height + 1))
    {
        const QImage first = a.convertToFormat(QImage::Format_RGB888);
        const QImage second = b.convertToFormat(QImage::Format_RGB888);
        for (int y = 0; y < m_height; ++y) {
            addRow(first.constScanLine(y), second.constScanLine(y), y);
        }
    }

    [[nodiscard]] PictureDifference result() const
    {
        PictureDifference difference;
        const double pixels = static_cast<double>(m_width) * m_height;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double shift = sumAt(m_width, m_height)[channel] / pixels;
            if (std::abs(shift) > std::abs(difference.shift)) {
                difference.shift = shift;
            }
        }
        constexpr int kSquare = PictureDifference::kSquare;
        for (int y = 0; y + kSquare <= m_height; ++y) {
            for (int x = 0; x + kSquare <= m_width; ++x) {
                if (const double worst = meanOfSquare(x, y); worst > difference.worst) {
                    difference.worst = worst;
                    difference.x = x;
                    difference.y = y;
                }
            }
        }
        return difference;
    }

private:
    using Sums = std::array<double, 3>;

    [[nodiscard]] const Sums& sumAt(int x, int y) const
    {
        return m_sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width + 1) +
                      static_cast<std::size_t>(x)];
    }

    /// Sums of all pixels to the left and above.
    void addRow(const uchar* a, const uchar* b, int y)
    {
        Sums row{};
        for (int x = 0; x < m_width; ++x) {
            const auto to =
                static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(m_width + 1) +
                static_cast<std::size_t>(x + 1);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double difference = static_cast<double>(*b++) - static_cast<double>(*a++);
                row[channel] += difference;
                m_sums[to][channel] = sumAt(x + 1, y)[channel] + row[channel];
            }
        }
    }

    [[nodiscard]] double meanOfSquare(int x, int y) const
    {
        constexpr int kSquare = PictureDifference::kSquare;
        double worst = 0.0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double sum = sumAt(x + kSquare, y + kSquare)[channel] -
                               sumAt(x, y + kSquare)[channel] - sumAt(x + kSquare, y)[channel] +
                               sumAt(x, y)[channel];
            worst = std::max(worst, std::abs(sum) / (kSquare * kSquare));
        }
        return worst;
    }

    int m_width;
    int m_height;
    std::vector<Sums> m_sums;
};

inline PictureDifference comparePictures(const QImage& a, const QImage& b)
{
    return PictureComparison(a, b).result();
}

} // namespace crowd::testing
