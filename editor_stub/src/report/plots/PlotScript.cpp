#include "console/Texts.h"
#include "report/figures/Numbers.h"
#include "report/plots/PlotLayout.h"
#include "report/plots/Plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <limn/base/TerminalText.h>
#include <set>

namespace limn::study
{

namespace
{

// Okabe and Ito's colours, which people tell apart whatever colours they see, without their yellow,
// which vanishes on white.
constexpr std::array k_Colors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                 "#56B4E9", "#E69F00", "#7F7F7F"};
constexpr std::array k_Filled = {7, 5, 9, 11, 13, 15}; // gnuplot's point types
constexpr std::array k_Hollow = {6, 4, 8, 10, 12, 14};
constexpr const char* k_FrontName = "Pareto front";
constexpr const char* k_Muted = "#6a737d";
constexpr const char* k_Better = "better";
constexpr const char* k_BetterColor = "#00734f";
constexpr double k_LetterWidth = 0.62; ///< of DejaVu Sans, of its size, on average

struct Layout
{
    int width;  ///< pixels
    int height; ///< pixels
    double font;
    double left; ///< margins, pixels
    double right;
    double top;
    double bottom; ///< without the key
};

Layout LayoutOf(PlotFormat format)
{
    return format == PlotFormat::NarrowSvg ? Layout{380, 434, 12.0, 58.0, 16.0, 36.0, 56.0}
                                           : Layout{860, 560, 14.0, 74.0, 28.0, 64.0, 74.0};
}

/// Returns the text in single quotes. Within them gnuplot obeys nothing except the closing quote,
/// which is written as a typographic apostrophe, since two quotes at the beginning of a text do
/// close it. OneLine leaves no line break.
std::string Quoted(const std::string& text)
{
    return "'" + Replaced(OneLine(text), "'", "’") + "'";
}

/// A tick's text is a format.
std::string QuotedTick(const std::string& text)
{
    return Quoted(Replaced(text, "%", "%%"));
}

/// Returns the name of a technique for plots, short enough for a phone.
std::string ShortName(const std::string& name)
{
    return Shortened(name, 36);
}

double TextWidth(const std::string& text, double font)
{
    const auto letters = std::ranges::count_if(
        OneLine(text), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    return static_cast<double>(letters) * font * k_LetterWidth;
}

/// Articles' lines are broken, and so are those whose colour another line has already.
std::string Dashes(const PlotSeries& series)
{
    const bool isAgain = series.style >= k_Colors.size();
    return series.isArticle ? (isAgain ? " dt '.'" : " dt '-'") : (isAgain ? " dt '_.'" : "");
}

std::string Places(std::initializer_list<double> values)
{
    return Joined(values, " ", Exact) + "\n";
}

class ScriptWriter
{
public:
    ScriptWriter(const Plot& plot, PlotFormat format)
        : m_Plot(plot), m_Format(format), m_Layout(LayoutOf(format))
    {
        std::vector<double> xs;
        std::vector<double> ys;
        for (const PlotSeries& series : plot.series)
        {
            for (const PlotPoint& point : series.points)
            {
                xs.insert(xs.end(),
                          {point.at.milliseconds, Positive(point.barX.first), point.barX.second});
                ys.insert(ys.end(),
                          {point.at.error, Positive(point.barY.first), point.barY.second});
            }
        }
        AddNearVerticals(xs);
        m_X = plot.ticksX.empty() ? MakeLogAxis(xs) : MakeLogAxis(plot.ticksX);
        m_Y = MakeLogAxis(ys);
        ReserveKey();
    }

    std::string Write()
    {
        AddTerminal();
        AddAxes();
        AddVerticals();
        AddNames();
        AddData();
        return m_Text + "plot " + Joined(m_Drawn, ", \\\n     ") + "\n";
    }

private:
    /// A quartile at or below zero does not make the axis longer.
    static double Positive(double bar) { return bar > 0.0 ? bar : std::nan(""); }

    /// Adds the verticals near the points. A vertical more than ten times farther away than all
    /// points is drawn at the end of the axis, because it would take their room.
    void AddNearVerticals(std::vector<double>& xs) const
    {
        double least = std::numeric_limits<double>::infinity();
        double most = 0.0;
        for (const double x : xs)
        {
            least = x > 0.0 ? std::min(least, x) : least;
            most = x > most ? x : most;
        }
        for (const auto& [x, name] : m_Plot.verticals)
        {
            if (x >= least / 10.0 && x <= most * 10.0)
            {
                xs.push_back(x);
            }
        }
    }

    double plotWidth() const { return m_Layout.width - m_Layout.left - m_Layout.right; }
    double plotHeight() const { return m_Layout.height - m_Layout.top - m_Layout.bottom; }
    double PixelX(double x) const { return m_Layout.left + m_X.Part(x) * plotWidth(); }
    double PixelY(double y) const { return m_Layout.top + (1.0 - m_Y.Part(y)) * plotHeight(); }
    std::string AtPixel(double x, double y) const
    {
        return "graph " + Exact((x - m_Layout.left) / plotWidth()) + ",graph " +
               Exact(1.0 - (y - m_Layout.top) / plotHeight());
    }

    /// Room for the key below the plot, in as many columns as there is room for.
    void ReserveKey()
    {
        double widest = m_Plot.front.empty() ? 0.0 : TextWidth(k_FrontName, m_Layout.font);
        std::size_t count = m_Plot.front.empty() ? 0 : 1;
        for (const PlotSeries& series : m_Plot.series)
        {
            widest = std::max(widest, TextWidth(ShortName(series.name), m_Layout.font));
            count += series.points.empty() ? 0 : 1;
        }
        const double column = widest + 4.0 * m_Layout.font;
        // gnuplot makes as many columns as fit between the ends of the axis, and no more.
        const auto most = static_cast<std::size_t>(std::max(1.0, plotWidth() / column));
        m_KeyColumns = std::min(most, std::max<std::size_t>(count, 1));
        const std::size_t rows = (count + m_KeyColumns - 1) / m_KeyColumns;
        const double height = (static_cast<double>(rows) + 1.0) * m_Layout.font *
                              (m_Format == PlotFormat::Png ? 1.2 : 1.62);
        m_Layout.bottom += height;
        m_Layout.height += static_cast<int>(height);
    }

    void AddTerminal()
    {
        const std::string font = " noenhanced font 'DejaVu Sans," + Exact(m_Layout.font) + "'";
        m_Text = m_Format == PlotFormat::Png
                     ? "set terminal pngcairo size " + std::to_string(m_Layout.width * 2) + "," +
                           std::to_string(m_Layout.height * 2) + font +
                           " fontscale 1.5 linewidth 2 pointscale 2 background '#ffffff'\n"
                     : "set terminal svg size " + std::to_string(m_Layout.width) + "," +
                           std::to_string(m_Layout.height) + " dynamic" + font + " name '" +
                           m_Plot.file +
                           (m_Format == PlotFormat::NarrowSvg ? "_narrow'\n"
                                                              : "' background '#ffffff'\n");
        m_Text += "set encoding utf8\n";
        const double width = m_Layout.width;
        const double height = m_Layout.height;
        m_Text += "set lmargin at screen " + Exact(m_Layout.left / width) +
                  "\nset rmargin at screen " + Exact(1.0 - m_Layout.right / width) +
                  "\nset tmargin at screen " + Exact(1.0 - m_Layout.top / height) +
                  "\nset bmargin at screen " + Exact(m_Layout.bottom / height) + "\n";
        if (m_Format != PlotFormat::NarrowSvg)
        {
            m_Text += "set title " + Quoted(m_Plot.title) + " font ',17' offset 0,0.6\n";
        }
        m_Text += "set key at screen 0.5,screen " + Exact(4.0 / height) +
                  " center bottom horizontal Left reverse samplen 2 maxcols " +
                  std::to_string(m_KeyColumns) + "\n";
    }

    void AddAxes()
    {
        m_Text += "set logscale xy\nset border 3 lw 1\nset tics nomirror out scale 0.6\n"
                  "set grid lc rgb '#d0d5db' lw 0.6 lt 1\nset errorbars small\n";
        AddAxis("x", m_X, m_Plot.labelX, plotWidth());
        AddAxis("y", m_Y, m_Plot.labelY, plotHeight());
    }

    void AddAxis(const std::string& axis, const LogAxis& range, const std::string& label,
                 double length)
    {
        m_Text += "set " + axis + "range [" + Exact(range.low) + ":" + Exact(range.high) + "]\n";
        // Along y it stands above the axis, to be read without turning one's head.
        const std::string named = Quoted(label + " (logarithmic)");
        m_Text += axis == "x" ? "set xlabel " + named + " offset 0,0.1\n"
                              : "set label " + named + " at " +
                                    AtPixel(6.0, m_Layout.top - 1.5 * m_Layout.font) + " left\n";
        std::string ticks;
        double free = 1e9; // texts along x must not meet; the last one stays
        std::vector<std::pair<double, std::string>> places = range.ticks;
        std::ranges::sort(places, std::greater<>());
        for (const auto& [value, text] : places)
        {
            const double half =
                0.5 * (axis == "x" ? TextWidth(text, m_Layout.font) + 6.0 : m_Layout.font);
            const double place = range.Part(value) * length;
            const bool isFree = axis == "y" || place + half <= free;
            free = isFree ? place - half : free;
            ticks +=
                (ticks.empty() ? "" : ", ") + QuotedTick(isFree ? text : "") + " " + Exact(value);
        }
        m_Text += "set " + axis + "tics (" + ticks + ")\n";
    }

    void AddVerticals()
    {
        std::multiset<double> places;
        for (const auto& [x, what] : m_Plot.verticals)
        {
            const bool isOutside = m_X.Clamped(x) != x;
            const std::string name =
                what + " " + Readable(x) + " ms" + (isOutside ? ", farther out" : "");
            const double width = TextWidth(name, m_Layout.font);
            const double place = PixelX(x);
            m_Text += "set arrow from " + AtPixel(place, m_Layout.top) + " to " +
                      AtPixel(place, m_Layout.top + plotHeight()) + " nohead lw 1.5 dt 2 lc rgb '" +
                      k_Muted + "'\n";
            const double side = place - m_Layout.left > 2.0 * m_Layout.font ? -1.0 : 1.0;
            const auto beside = static_cast<double>(places.count(place)); // both farther out
            places.insert(place);
            const double center = place + side * (0.7 + 1.4 * beside) * m_Layout.font;
            // In the middle at an end, where points may be drawn that belong farther out, too.
            const double top = m_Layout.top + (isOutside ? 0.5 * (plotHeight() - width) : 4.0);
            m_Text += "set label " + Quoted(name) + " at " + AtPixel(center, top) +
                      " right rotate by 90 textcolor rgb '" + k_Muted + "'\n";
            m_Obstacles.push_back(
                {place - 2.0, m_Layout.top, place + 2.0, m_Layout.top + plotHeight()});
            m_Obstacles.push_back({center - 0.6 * m_Layout.font, top - 4.0,
                                   center + 0.6 * m_Layout.font, top + width + 4.0});
        }
    }

    /// Adds the things that names must not cover: points, their bars and the front.
    void AddObstacles()
    {
        const auto add = [this](double x0, double y0, double x1, double y1, double half)
        {
            if (std::isnan(x0 + y0))
            {
                return; // no bar
            }
            const auto [left, right] =
                std::minmax({PixelX(x0), PixelX(x1)}); // a pair of values, not of references
            const auto [top, bottom] = std::minmax({PixelY(y0), PixelY(y1)});
            m_Obstacles.push_back({left - half, top - half, right + half, bottom + half});
        };
        for (const PlotSeries& series : m_Plot.series)
        {
            for (const PlotPoint& point : series.points)
            {
                const auto [x, y] = point.at;
                add(x, y, x, y, 6.0);
                add(point.barX.first, y, point.barX.second, y, 2.0);
                add(x, point.barY.first, x, point.barY.second, 2.0);
            }
        }
        if (!m_Plot.front.empty())
        {
            const auto [x, y] = m_Plot.front.front();
            add(x, y, x, m_Y.high, 2.0);
        }
        for (std::size_t i = 0; i < m_Plot.front.size(); ++i)
        {
            const auto [x, y] = m_Plot.front[i];
            const bool isLast = i + 1 == m_Plot.front.size();
            const auto [end, next] = isLast ? TimeAndError{m_X.high, y} : m_Plot.front[i + 1];
            add(x, y, end, y, 2.0);
            add(end, y, end, next, 2.0);
        }
    }

    /// An arrow to the corner of small values, as near to that corner as there is room.
    void AddBetter()
    {
        if (!m_Plot.isLessBetter)
        {
            return;
        }
        const double size = 2.2 * m_Layout.font; // of the arrow, along each axis
        const double width = size + TextWidth(k_Better, m_Layout.font) + 4.0;
        const double height = size + 0.6 * m_Layout.font;
        const double margin = 8.0;
        const double right = m_Layout.width - m_Layout.right - width;
        const double bottom = m_Layout.top + plotHeight() - margin - height;
        double nearest = std::numeric_limits<double>::infinity();
        PixelBox place{};
        for (double y = bottom; y >= m_Layout.top; y -= margin)
        {
            for (double x = m_Layout.left + margin; x <= right; x += margin)
            {
                const PixelBox box{x, y, x + width, y + height};
                const double distance = std::hypot(x - m_Layout.left, y - bottom);
                const bool isFree = std::ranges::none_of(m_Obstacles, [&box](const PixelBox& one)
                                                         { return Overlap(box, one) > 0.0; });
                if (isFree && distance < nearest)
                {
                    nearest = distance;
                    place = box;
                }
            }
        }
        if (std::isinf(nearest))
        {
            return; // the caption says it as well
        }
        m_Text += "set arrow from " + AtPixel(place.left + size, place.bottom - size) + " to " +
                  AtPixel(place.left, place.bottom) + " head filled size screen " +
                  Exact(0.8 * m_Layout.font / m_Layout.width) + ",25 lw 2 lc rgb '" +
                  k_BetterColor + "'\nset label '" + k_Better + "' at " +
                  AtPixel(place.left + size + 4.0, place.bottom - size) + " left textcolor rgb '" +
                  k_BetterColor + "'\n";
        m_Obstacles.push_back(place);
    }

    void AddNames()
    {
        AddObstacles();
        AddBetter();
        std::vector<const PlotPoint*> points;
        for (const PlotSeries& series : m_Plot.series)
        {
            for (const PlotPoint& point : series.points)
            {
                if (!point.name.empty())
                {
                    points.push_back(&point);
                }
            }
        }
        std::stable_partition(points.begin(), points.end(),
                              [](const PlotPoint* point) { return point->isOnFront; });
        std::vector<LabelWish> wishes;
        for (const PlotPoint* point : points)
        {
            wishes.push_back({PixelX(point->at.milliseconds), PixelY(point->at.error),
                              TextWidth(ShortName(point->name), m_Layout.font) + 2.0,
                              m_Layout.font * 1.15, point->isOnFront});
        }
        const PixelBox frame{m_Layout.left + 2.0, m_Layout.top, m_Layout.width - 2.0,
                             m_Layout.top + plotHeight() - 2.0};
        const auto boxes = PlaceLabels(wishes, m_Obstacles, frame);
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
            if (boxes[i])
            {
                AddName(*points[i], wishes[i], *boxes[i]);
            }
        }
    }

    /// The text, and a line to its point where it stands off.
    void AddName(const PlotPoint& point, const LabelWish& wish, const PixelBox& box)
    {
        constexpr double k_Near = 14.0; // pixels
        const double nearX = std::clamp(wish.x, box.left, box.right);
        const double nearY = std::clamp(wish.y, box.top, box.bottom);
        if (std::hypot(nearX - wish.x, nearY - wish.y) > k_Near)
        {
            m_Text += "set arrow from " + AtPixel(wish.x, wish.y) + " to " + AtPixel(nearX, nearY) +
                      " nohead lw 0.8 lc rgb '" + k_Muted + "'\n";
        }
        // A text as wide as was reckoned fills the box; a narrower one stays at the point's side.
        const bool isLeft = box.right <= wish.x;
        const bool isRight = box.left >= wish.x;
        const double x = isLeft ? box.right : isRight ? box.left : (box.left + box.right) / 2.0;
        m_Text += "set label " + Quoted(ShortName(point.name)) + " at " +
                  AtPixel(x, (box.top + box.bottom) / 2.0) +
                  (isLeft    ? " right"
                   : isRight ? " left"
                             : " center") +
                  " front textcolor rgb '" +
                  (point.isOnFront || m_Plot.front.empty() ? "black" : k_Muted) + "'\n";
    }

    /// @return the block's name
    std::string AddBlock(const std::string& lines)
    {
        const std::string name = "$data" + std::to_string(++m_Blocks);
        m_Text += name + " << EOD\n" + lines + "EOD\n";
        return name;
    }

    void AddData()
    {
        if (!m_Plot.front.empty())
        {
            std::string lines = Places({m_X.Clamped(m_Plot.front[0].milliseconds), m_Y.high});
            for (const TimeAndError& point : m_Plot.front)
            {
                lines += Places({m_X.Clamped(point.milliseconds), m_Y.Clamped(point.error)});
            }
            lines += Places({m_X.high, m_Y.Clamped(m_Plot.front.back().error)});
            m_Drawn.push_back(AddBlock(lines) +
                              " using 1:2 with steps lw 2 lc rgb '#009E73' title " +
                              Quoted(k_FrontName));
        }
        for (const PlotSeries& series : m_Plot.series)
        {
            if (!series.points.empty())
            {
                AddSeries(series);
            }
        }
    }

    void AddSeries(const PlotSeries& series)
    {
        std::string points;
        std::string barsX;
        std::string barsY;
        for (const PlotPoint& point : series.points)
        {
            const double x = m_X.Clamped(point.at.milliseconds);
            const double y = m_Y.Clamped(point.at.error);
            points += Places({x, y});
            const auto bar = [&](const std::pair<double, double>& ends, const LogAxis& axis)
            {
                return std::isfinite(ends.first) && std::isfinite(ends.second)
                           ? Places({x, y, axis.Clamped(ends.first), axis.Clamped(ends.second)})
                           : "";
            };
            barsX += bar(point.barX, m_X);
            barsY += bar(point.barY, m_Y);
        }
        const std::string color =
            std::string(" lc rgb '") + k_Colors[series.style % k_Colors.size()] + "'";
        const int type = series.isArticle ? k_Hollow[series.style % k_Hollow.size()]
                                          : k_Filled[series.style % k_Filled.size()];
        for (const auto& [bars, axis] : {std::pair(barsX, "x"), std::pair(barsY, "y")})
        {
            if (!bars.empty())
            {
                m_Drawn.push_back(AddBlock(bars) + " using 1:2:3:4 with " + axis +
                                  "errorbars pt 0 ps 0 lw 1" + color + " notitle");
            }
        }
        m_Drawn.push_back(
            AddBlock(points) + " using 1:2 with " + (series.hasLine ? "linespoints" : "points") +
            " pt " + std::to_string(type) + (series.hasLine ? " ps 0.8 lw 1.6" : " ps 1 lw 2") +
            (series.hasLine ? Dashes(series) : "") + color + " title " +
            Quoted(ShortName(series.name)));
    }

    const Plot& m_Plot;
    PlotFormat m_Format;
    Layout m_Layout;
    LogAxis m_X;
    LogAxis m_Y;
    std::size_t m_KeyColumns = 1;
    std::vector<PixelBox> m_Obstacles;
    std::vector<std::string> m_Drawn; ///< behind `plot`
    int m_Blocks = 0;
    std::string m_Text;
};

} // namespace

std::string PlotScript(const Plot& plot, PlotFormat format)
{
    return ScriptWriter(plot, format).Write();
}

} // namespace limn::study
