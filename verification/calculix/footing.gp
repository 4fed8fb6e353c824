# gnuplot -c footing.gp FOLDER: pressure below the strip over settlement, and the surface at the end, from
# the tables that script/compare_footing writes
folder = ARG1
set terminal svg size 900,420 font "sans,13" background rgb "white"
set output folder."/footing.svg"
set datafile separator ","
set grid lc rgb "#dddddd"
set key bottom right
set multiplot layout 1,2
set xlabel "settlement / mm"
set ylabel "pressure below the strip / kPa"
set xrange [0:100]
set yrange [0:*]
plot folder."/footing_large.csv" using ($1*1e3):2 with linespoints lw 2 pt 7 ps 0.4 lc rgb "#D55E00" \
         title "large strain", \
     folder."/footing.csv" using ($1*1e3):2 with linespoints lw 2 pt 7 ps 0.4 lc rgb "#0072B2" \
         title "small strain"
set xlabel "distance from the middle / m"
set ylabel "surface at the end / mm"
set xrange [0:4]
set yrange [*:*]
plot folder."/footing_large.surface.csv" using 1:($2*1e3) with linespoints lw 2 pt 7 ps 0.4 \
         lc rgb "#D55E00" title "large strain", \
     folder."/footing.surface.csv" using 1:($2*1e3) with linespoints lw 2 pt 7 ps 0.4 \
         lc rgb "#0072B2" title "small strain"
unset multiplot
