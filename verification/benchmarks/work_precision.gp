# gnuplot -c work_precision.gp FOLDER: error of single calls over their time, for tolerances 1e-2 ... 1e-10
folder = ARG1
load folder."/pictures.gp"
set terminal svg size 960,560 enhanced font "sans,13" background rgb "white"
set output folder."/work_precision.svg"
set datafile separator ","
set key outside right top samplen 2 spacing 1.2 Left reverse
set logscale xy
set format y "10^{%T}"
set xlabel "time of a call / time of a dependent exp"
set ylabel "error of the stress / |stress|"
set xrange [20:*]
set yrange [1e-14:1e-1]
set grid lc rgb "#dddddd"
exponent = "-6 -4 -3 -2" # of the increments
colour = "#0072B2 #009E73 #E69F00 #D55E00"
of(i, x, value) = abs(x / 10.0**word(exponent, i) - 1) < 1e-3 ? value : NaN
data = folder."/work_precision.csv"
other = folder."/work_precision_umat.csv"
power(i) = "10^{".word(exponent, i)."}"
plot for [i=1:4] data using 3:(of(i, $1, $4)) with linespoints lw 2 pt 7 ps 0.5 \
        lc rgb word(colour, i) title "Δε ".power(i).", median", \
    for [i=1:4] data using 3:(of(i, $1, $5)) with lines lw 1 dt 2 lc rgb word(colour, i) \
        title "Δε ".power(i).", largest", \
    for [k=1:umats] for [i=1:4] other using 3:($1 == k ? of(i, $2, $4) : NaN) with points \
        pt 2 * k + 2 ps 1.1 lw 1.5 lc rgb word(colour, i) title (i == 4 ? umat[k] : "") noenhanced
