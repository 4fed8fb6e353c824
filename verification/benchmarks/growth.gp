# gnuplot -c growth.gp FOLDER: time per point over the number of points, and where the caches are full
folder = ARG1
load folder."/pictures.gp"
set terminal svg size 900,760 enhanced font "sans,13" background rgb "white"
set output folder."/growth.svg"
set datafile separator ","
set logscale xy
set format x "10^{%T}"
set grid lc rgb "#dddddd"
set lmargin 10
set rmargin 4
set key at graph 0.98, graph 0.95 right top samplen 2 opaque
cache = "L1 L2 L3"
bytes(i) = value(word(cache, i))
full(i, per_point) = bytes(i) / per_point
array mark[3] = ["L1", "L2", "L3"]
set multiplot

set size 1, 0.5
set origin 0, 0.5
sand_point = 224.0 # strain, stress, state, report
set title "Sand, points of one call (224 bytes each)"
set ylabel "ns per point"
set xlabel "points"
set xrange [1:1e6]
set yrange [10:1e4]
do for [i=1:3] {
    set arrow i from full(i, sand_point), graph 0 to full(i, sand_point), graph 1 nohead dt 3 lc rgb "#888888"
    set label i mark[i]." full" at full(i, sand_point), graph 0.06 left offset 0.4, 0 tc rgb "#555555"
}
data = folder."/growth_sand.csv"
plot data using 2:($1 < 1e-5 ? $3 : NaN) with linespoints lw 2 pt 7 ps 0.5 lc rgb "#0072B2" title "Δε 10^{-6}", \
    data using 2:($1 > 1e-5 ? $3 : NaN) with linespoints lw 2 pt 7 ps 0.5 lc rgb "#009E73" title "Δε 10^{-4}"

set origin 0, 0
set title sprintf("Material points, CPDI (%.0f bytes of elastic, %.0f of sand, nodes included)", \
    particle_elastic, particle_sand)
set ylabel "ns per particle and step"
set xlabel "particles"
set xrange [1:1e6]
set yrange [20:2e3]
do for [i=1:3] {
    set arrow i from full(i, particle_sand), graph 0 to full(i, particle_sand), graph 1 nohead dt 3 lc rgb "#888888"
    set label i mark[i]." full" at full(i, particle_sand), graph 0.1 left offset 0.4, 0 tc rgb "#555555"
}
data = folder."/growth_mpm.csv"
plot data using 2:($1 == 1 ? $3 : NaN) with linespoints lw 2 pt 7 ps 0.5 lc rgb "#D55E00" title "sand", \
    data using 2:($1 == 0 ? $3 : NaN) with linespoints lw 2 pt 7 ps 0.5 lc rgb "#0072B2" title "elastic"
unset multiplot
