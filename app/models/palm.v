angle increment: 45
initial line width: 22
initial color: 1
tropism direction: 0,1,0
material: 1 trunk kind=bark color=0.45,0.40,0.34 roughness=0.95
material: 2 leaflet kind=leaf color=0.30,0.46,0.16 roughness=0.45 translucency=0.35
material: 3 rachis kind=stem color=0.46,0.55,0.22 roughness=0.6
organ: f leaflet kind=blade material=2 length=78 width=5.2 petiole=0 widest=0.35 tip=0.6 base=0.5 fold=30 curl=35
calendar: f evergreen
