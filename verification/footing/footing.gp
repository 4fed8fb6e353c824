# gnuplot -c footing.gp FOLDER: sigma_zz of the first row of particles below a strip, by its mean, and the pressure over
# the settlement, from profiles.csv and loads.csv that footing.py writes for all cases
folder = ARG1
set terminal svg size 1000,720 font "sans,13" background rgb "white"
set output folder."/footing.svg"
set datafile separator ","
set grid lc rgb "#dddddd"
array name[4] = ["fca", "gca_gated", "pca", "surface"]
array called[4] = ["FCA", "GCA, gated", "PCA", "surface"]
array colour[4] = ["#56B4E9", "#0072B2", "#009E73", "#D55E00"]
set multiplot layout 2,2
set xlabel "distance from the axis / m"
set ylabel "σ_{zz} of a particle / mean below the strip"
set xrange [0:0.55]
set yrange [0:2]
set arrow from 0.5,0 to 0.5,2 nohead lc rgb "#888888" dt 2
set key bottom left
set title "100 mm deep, h = 0.1 m"
plot for [i=1:4] folder."/profiles.csv" index name[i] using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb colour[i] title called[i]
set title "h = 0.05 m"
plot for [i=1:4] folder."/profiles.csv" index name[i]."_half" using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb colour[i] title called[i]
set title "dense, without surcharge, h = 0.1 m"
array free[4] = ["free_fca", "free_gca_gated", "free_pca", "free"]
plot for [i=1:4] folder."/profiles.csv" index free[i] using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb colour[i] title called[i]
unset arrow
set key top left
set xlabel "settlement / mm"
set ylabel "pressure below the strip / kPa"
set xrange [0:100]
set yrange [0:*]
set title "20 kPa around the strip"
plot for [i=1:4] folder."/loads.csv" index name[i] using 1:2 with lines lw 2 lc rgb colour[i] title called[i], \
    for [i=1:4] folder."/loads.csv" index name[i]."_half" using 1:2 with lines lw 1 dt 2 lc rgb colour[i] notitle, \
    folder."/loads.csv" index "finite elements" using 1:2 with points pt 6 lc rgb "#222222" title "finite elements"
unset multiplot
