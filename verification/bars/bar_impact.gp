# gnuplot -c bar_impact.gp FOLDER: contact force of two bars over time, from bar_impact.csv
folder = ARG1
set terminal svg size 900,520 font "sans,13" background rgb "white"
set output folder."/bar_impact.svg"
set datafile separator ","
set key outside bottom center horizontal maxcols 3 samplen 2
set bmargin 9
set xlabel "time after the touch / (L/c)"
set ylabel "contact force / (ρ c v)"
set xrange [-5:3]
set yrange [0:1.5]
set grid lc rgb "#dddddd"
data = folder."/bar_impact.csv"
theory(t) = t < 0 || t > 2 ? 0 : 1
set samples 2000
plot theory(x) with lines lw 1 dt 2 lc rgb "#222222" title "wave theory", \
    data using 1:2 with lines lw 2 lc rgb "#0072B2" title "GCA k 6, gap gate", \
    data using 1:5 with lines lw 2 dt 3 lc rgb "#56B4E9" title "FCA, gap gate", \
    data using 1:7 with lines lw 2 lc rgb "#009E73" title "PCA", \
    data using 1:8 with lines lw 2 dt 2 lc rgb "#000000" title "surface", \
    data using 1:3 with lines lw 2 lc rgb "#D55E00" title "GCA k 6, no gate", \
    data using 1:4 with lines lw 2 lc rgb "#E69F00" title "GCA k 6, no gate, s to a centre", \
    data using 1:6 with lines lw 2 lc rgb "#CC79A7" title "FCA, no gate"
